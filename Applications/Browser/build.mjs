// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Makes the page, one file: build.mjs FOLDER OUTPUT. The folder has node_modules/, app/ (this folder), viewer/ and picture/page.html
// (Applications/Picture) and npm/ (the package).
import { createRequire } from 'node:module';
import { readFile, writeFile } from 'node:fs/promises';
import { resolve } from 'node:path';

const folder = resolve(process.argv[2]);
const { build } = createRequire(resolve(folder, 'package.json'))('esbuild');
const at = (...names) => resolve(folder, ...names);
const POLICY = [
  "default-src 'none'",
  'img-src data: blob:',
  "style-src 'unsafe-inline'",
  "script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:",
  'worker-src blob:',
].join('; ');

async function bundle(entry, plugins = []) {
  const { outputFiles } = await build({
    entryPoints: [entry],
    bundle: true,
    minify: true,
    write: false,
    format: 'iife',
    target: 'es2022',
    charset: 'ascii',
    legalComments: 'none',
    logLevel: 'warning',
    nodePaths: [at('node_modules')],
    loader: { '.wasm': 'binary' },
    plugins,
  });
  return outputFiles[0].text;
}

/** The package, and the text of its worker as a module of its own. */
function modules(workerText) {
  return {
    name: 'modules',
    setup(builder) {
      builder.onResolve({ filter: /^bonedecimate\// }, ({ path }) => ({ path: at('npm', path.slice('bonedecimate/'.length)) }));
      builder.onResolve({ filter: /^worker-text$/ }, ({ path }) => ({ path, namespace: 'text' }));
      builder.onLoad({ filter: /.*/, namespace: 'text' }, () => ({ contents: workerText, loader: 'text' }));
    },
  };
}

/** A block of the program's page, with values in place of their names. */
async function block(name, values) {
  const page = await readFile(at('picture', 'page.html'), 'utf8');
  const text = page.split(`<!-- block ${name} -->\n`)[1].split('<!-- end -->')[0];
  return text.replace(/\{\{(.*?)\}\}/g, (_, key) => values[key] ?? '');
}

const script = await bundle(at('app', 'app.js'), [modules(await bundle(at('npm', 'worker.js')))]);
const licenses = await Promise.all([at('viewer', 'LICENSES.txt'), at('app', 'LICENSES.txt')].map((file) => readFile(file, 'utf8')));
const head = (await block('head', { title: 'Simplify a bone surface, or compare two' })).replace(/(Security-Policy" content=")[^"]*/, `$1${POLICY}`);
const viewer = await block('viewer', {
  before: 'before',
  after: 'after',
  legend: 'Distance to the other surface, mm',
  parts: 'Parts',
  rounding: 'Between points, colors are interpolated: inside a large triangle the distance may be smaller or larger.',
  x: 'x',
  y: 'y',
  z: 'z',
});
const body = await readFile(at('app', 'app.html'), 'utf8');
const safe = script.replaceAll('</script', '<\\/script');
await writeFile(
  resolve(process.argv[3]),
  `${head}<body>\n${body}<template id="viewer-template">\n${viewer}</template>\n<script>\n/*\n${licenses.join('\n')}*/\n${safe}</script>\n</body>\n</html>\n`
);
