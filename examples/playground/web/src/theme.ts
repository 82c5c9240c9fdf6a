// SPDX-License-Identifier: MIT

/** The colours of the canvas. Those of the light theme are the library's (io/text/svg_style.hpp). */
export interface Palette {
  page: string;
  ground: string;
  outline: string;
  obstacle: string;
  zone: string;
  free: string;
  visited: string;
  generated: string;
  tree: string;
  forwardRectangle: string;
  backwardRectangle: string;
  forwardPassage: string;
  backwardPassage: string;
  current: string;
  route: string;
  refused: string;
  proof: string;
  ink: string;
  faint: string;
  select: string;
}

const light: Palette = {
  page: '#eef1f4',
  ground: '#f8fafc',
  outline: '#33414e',
  obstacle: '#4a5763',
  zone: '#f6d9b8',
  free: '#f8fafc',
  visited: '#b3d9f5',
  generated: '#dcecf8',
  tree: '#6fa58f',
  forwardRectangle: '#c9a000',
  backwardRectangle: '#3d9455',
  forwardPassage: '#d4a000',
  backwardPassage: '#1b7837',
  current: '#f07d00',
  route: '#7a8794',
  refused: '#c1121f',
  proof: '#0b7a4b',
  ink: '#222b33',
  faint: '#d5dbe1',
  select: '#f07d00',
};
const dark: Palette = {
  page: '#0f1318',
  ground: '#171c22',
  outline: '#8b98a5',
  obstacle: '#8795a3',
  zone: '#4c3a27',
  free: '#171c22',
  visited: '#23506f',
  generated: '#25415a',
  tree: '#5f9580',
  forwardRectangle: '#d9b32e',
  backwardRectangle: '#5cb874',
  forwardPassage: '#e0b840',
  backwardPassage: '#5cb874',
  current: '#ff9d3c',
  route: '#95a2af',
  refused: '#ff6b6b',
  proof: '#4cc38a',
  ink: '#e6ebf0',
  faint: '#2e3740',
  select: '#ff9d3c',
};

/** Colours of planners: the library's, of which the first six are after Okabe and Ito. */
const lightCurves = [
  '#0072b2',
  '#d55e00',
  '#009e73',
  '#cc79a7',
  '#56b4e9',
  '#a07400',
  '#8b1a1a',
  '#5e3c99',
  '#7fbf2f',
  '#e31a8c',
  '#333333',
  '#00b3b3',
];
const darkCurves = [
  '#4aa8e0',
  '#f07d32',
  '#2fc494',
  '#e09cc2',
  '#8fd0f5',
  '#d0a030',
  '#d86a6a',
  '#9f83d6',
  '#9fdc4f',
  '#f264b0',
  '#c8c8c8',
  '#2fd0d0',
];

export type ThemeChoice = 'auto' | 'light' | 'dark';

/** The choice of the reader, or that of the system. */
export class Theme {
  choice: ThemeChoice = 'auto';
  private readonly system = matchMedia('(prefers-color-scheme: dark)');

  constructor(onChange: () => void) {
    this.system.addEventListener('change', () => {
      this.apply();
      onChange();
    });
    this.apply();
  }

  get isDark(): boolean {
    return this.choice === 'auto' ? this.system.matches : this.choice === 'dark';
  }
  get palette(): Palette {
    return this.isDark ? dark : light;
  }
  curve(index: number): string {
    const colours = this.isDark ? darkCurves : lightCurves;
    return colours[index % colours.length] ?? '#0072b2';
  }
  toggle(): void {
    this.choice = this.isDark ? 'light' : 'dark';
    this.apply();
  }
  private apply(): void {
    document.documentElement.dataset['theme'] = this.isDark ? 'dark' : 'light';
  }
}
