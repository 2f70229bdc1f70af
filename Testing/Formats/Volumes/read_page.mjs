// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Reads NIfTI files as the page in the browser does: a path a line, and for each a line of JSON. read_page.mjs NIFTI_MJS, a copy of
// Applications/Browser/nifti.js beside node_modules/.
import { readFileSync } from 'node:fs';
import { createInterface } from 'node:readline';
import { pathToFileURL } from 'node:url';

const { readLabelMap } = await import(pathToFileURL(process.argv[2]));
for await (const path of createInterface({ input: process.stdin })) {
  let result;
  try {
    const bytes = readFileSync(path);
    const { labels, grid } = readLabelMap(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
    result = { labels: Array.from(labels), grid };
  } catch (error) {
    result = { error: error.message };
  }
  process.stdout.write(`${JSON.stringify(result)}\n`);
}
