// node validate.mjs FILE… prints a line a file and a line each message of the Khronos glTF-Validator.
// Exits 1 if a file has errors or cannot be read, 2 without files.
import { readFile } from 'node:fs/promises';
import { dirname, resolve } from 'node:path';
import validator from 'gltf-validator';

const severities = ['error', 'warning', 'info', 'hint'];

async function validate(path) {
  const bytes = new Uint8Array(await readFile(path));
  return validator.validateBytes(bytes, {
    uri: path,
    maxIssues: 0,
    externalResourceFunction: async (uri) =>
      new Uint8Array(await readFile(resolve(dirname(path), decodeURIComponent(uri)))),
  });
}

async function print(path) {
  try {
    const { issues } = await validate(path);
    console.log(`${path}: ${issues.numErrors} errors, ${issues.numWarnings} warnings, ` +
      `${issues.numInfos} infos, ${issues.numHints} hints`);
    for (const { severity, code, message, pointer, offset } of issues.messages) {
      console.log(`  ${severities[severity]}: ${code} at ${pointer ?? `byte ${offset}`}: ${message}`);
    }
    return issues.numErrors === 0;
  } catch (error) {
    console.log(`${path}: cannot be validated: ${error.message ?? error}`);
    return false;
  }
}

const paths = process.argv.slice(2);
if (paths.length === 0) {
  console.error('usage: node validate.mjs FILE…');
  process.exit(2);
}
let sound = true;
for (const path of paths) sound = (await print(path)) && sound;
process.exit(sound ? 0 : 1);
