// SPDX-License-Identifier: MIT

import { noChange } from 'lit-html';
import {
  Directive,
  directive,
  PartType,
  type ElementPart,
  type PartInfo,
} from 'lit-html/directive.js';

/** Shows a value in a field, but not while somebody types there. */
class Editable extends Directive {
  constructor(info: PartInfo) {
    super(info);
    if (info.type !== PartType.ELEMENT) throw new Error('editable belongs to an element');
  }
  render(_value: string): unknown {
    return noChange;
  }
  override update({ element }: ElementPart, [value]: [string]): unknown {
    const field = element as HTMLInputElement;
    if (document.activeElement !== field && field.value !== value) field.value = value;
    return noChange;
  }
}

export const editable = directive(Editable);
