// The lines that a page of the documentation shows, so that they can be run.

import { readFileSync } from 'node:fs';

/// The first block of JavaScript under a heading.
export function linesUnder(documentation, heading) {
  const text = readFileSync(documentation, 'utf8');
  const section = text.slice(text.indexOf(`# ${heading}\n`));
  return section.match(/```js\n(.*?)```/s)[1];
}
