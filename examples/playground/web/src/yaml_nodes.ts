// SPDX-License-Identifier: MIT

import { isAlias, isMap, isScalar, isSeq, LineCounter, parseDocument, type ParsedNode } from 'yaml';
import type { YamlNode } from './protocol.ts';

const nullWords = new Set(['', '~', 'null', 'Null', 'NULL']);

/** The nodes of a YAML document, the root first. Throws an Error with the line of malformed YAML. */
export function yamlNodes(text: string): YamlNode[] {
  const lines = new LineCounter();
  // Keys that are given twice are the engine's to refuse; all scalars stay texts for it, too.
  const document = parseDocument(text, {
    schema: 'failsafe',
    lineCounter: lines,
    uniqueKeys: false,
    prettyErrors: false,
  });
  const error = document.errors[0];
  if (error) {
    const { line, col } = lines.linePos(error.pos[0]);
    throw new Error(`line ${line}, column ${col}: ${error.message}`);
  }
  const tree = new Tree(lines);
  tree.add(document.contents as ParsedNode | null, 1);
  return tree.nodes;
}

class Tree {
  readonly nodes: YamlNode[] = [];
  private readonly anchors = new Map<string, number>();

  constructor(private readonly lines: LineCounter) {}

  /** Returns the index of the node. An alias is the node that it stands for. */
  add(node: ParsedNode | null, parentLine: number): number {
    if (node && isAlias(node))
      return this.anchors.get(node.source) ?? this.push({ kind: 'nothing', line: parentLine });
    const line = node?.range ? this.lines.linePos(node.range[0]).line : parentLine;
    const index = this.push({ kind: 'nothing', line });
    const made = this.nodes[index];
    if (!node || !made) return index;
    if (node.anchor) this.anchors.set(node.anchor, index);
    if (isScalar(node)) {
      const value = String(node.value ?? '');
      const isNull = node.type === 'PLAIN' && nullWords.has(value);
      if (!isNull) Object.assign(made, { kind: 'scalar', text: value });
    } else if (isSeq(node)) {
      made.kind = 'list';
      made.children = node.items.map((item) => this.add(item as ParsedNode, line));
    } else if (isMap(node)) {
      made.kind = 'map';
      made.children = node.items.flatMap(({ key, value }) => [
        this.add(key as ParsedNode, line),
        this.add(value as ParsedNode | null, line),
      ]);
    }
    return index;
  }

  private push(node: YamlNode): number {
    return this.nodes.push(node) - 1;
  }
}

/** The value of a key of the root, such as `image`. */
export function rootValue(nodes: YamlNode[], key: string): string | undefined {
  const children = nodes[0]?.kind === 'map' ? (nodes[0].children ?? []) : [];
  for (let i = 0; i + 1 < children.length; i += 2) {
    if (nodes[children[i] ?? -1]?.text === key) return nodes[children[i + 1] ?? -1]?.text;
  }
  return undefined;
}
