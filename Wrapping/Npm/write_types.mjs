// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Writes the type of the options from the option table: write_types.mjs PACKAGE
import { writeFile } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';
import { resolve } from 'node:path';

const folder = resolve(process.argv[2]);
const { optionTable } = await import(pathToFileURL(resolve(folder, 'node.js')));

function typeOf({ kind, choices, unit }) {
  if (kind === 'choice') {
    return choices.map((choice) => `'${choice}'`).join(' | ');
  }
  return kind === 'number' && unit === 'mm' ? 'number | string' : kind;
}

const rows = await optionTable();
const members = rows.map(
  (row) => `  /** ${row.description} Takes ${row.values}; default ${row.default || 'none'}. */\n  ${row.name}?: ${typeOf(row)};`
);
const text = `// Generated from the option table.\n\nexport interface Options {\n${members.join('\n')}\n}\n`;
await writeFile(resolve(folder, 'options.d.ts'), text);
