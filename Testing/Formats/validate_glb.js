// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Validates GLB files with gltf-validator: as they are, and compressed ones also with the buffers that meshoptimizer's own decoder makes of them,
// whose contents the validator then checks. Prints a line for each file; ends with 1 if one has an error or a warning.
const fs = require("fs");
const { MeshoptDecoder } = require("meshoptimizer");
const validator = require("gltf-validator");
const MESHOPT = "EXT_meshopt_compression";

function chunksOf(file) {
  const size = file.readUInt32LE(12);
  return [JSON.parse(file.subarray(20, 20 + size)), file.subarray(28 + size)];
}

function decoded(file) {
  const [json, binary] = chunksOf(file);
  const buffer = Buffer.alloc(json.buffers[1].byteLength);
  for (const view of json.bufferViews) {
    const packed = view.extensions[MESHOPT];
    const bytes = binary.subarray(packed.byteOffset, packed.byteOffset + packed.byteLength);
    const target = new Uint8Array(packed.count * packed.byteStride);
    MeshoptDecoder.decodeGltfBuffer(target, packed.count, packed.byteStride, new Uint8Array(bytes), packed.mode);
    buffer.set(target, view.byteOffset);
    delete view.extensions;
    view.buffer = 0;
  }
  json.buffers = [{ byteLength: buffer.length }];
  json.extensionsUsed = json.extensionsRequired = json.extensionsUsed.filter((name) => name !== MESHOPT);
  let text = JSON.stringify(json);
  text = text.padEnd(Math.ceil(text.length / 4) * 4);
  const head = Buffer.alloc(20);
  [0x46546c67, 2, 28 + text.length + buffer.length, text.length, 0x4e4f534a].forEach((word, i) => head.writeUInt32LE(word, 4 * i));
  const second = Buffer.alloc(8);
  [buffer.length, 0x004e4942].forEach((word, i) => second.writeUInt32LE(word, 4 * i));
  return Buffer.concat([head, Buffer.from(text), second, buffer]);
}

async function main() {
  await MeshoptDecoder.ready;
  for (const name of process.argv.slice(2)) {
    const file = fs.readFileSync(name);
    const forms = [["as written", file]];
    if (chunksOf(file)[0].buffers.length > 1) {
      forms.push(["decoded", decoded(file)]);
    }
    for (const [what, bytes] of forms) {
      const { issues, info } = await validator.validateBytes(new Uint8Array(bytes));
      console.log(`${name} ${what}: ${issues.numErrors} errors, ${issues.numWarnings} warnings, ${info.totalTriangleCount} triangles`);
      for (const message of issues.messages.filter((one) => one.severity < 2)) {
        console.log(`  ${message.code} ${message.pointer}: ${message.message}`);
        process.exitCode = 1;
      }
    }
  }
}

main();
