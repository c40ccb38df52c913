// Checks glTF files with the Khronos validator: no errors, no warnings.
import { readFileSync } from "node:fs";
import validator from "gltf-validator";

let bad = 0;
for (const file of process.argv.slice(2)) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), { uri: file });
  const { numErrors, numWarnings, messages } = report.issues;
  const { drawCallCount, totalTriangleCount } = report.info;
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${messages.length} messages; ${drawCallCount} parts, ${totalTriangleCount} triangles`);
  if (numErrors + numWarnings > 0 || drawCallCount === 0) {
    console.error(JSON.stringify(messages.slice(0, 10), null, 2));
    bad += 1;
  }
}
if (process.argv.length < 3) {
  console.error("no files to check");
  bad += 1;
}
process.exitCode = bad === 0 ? 0 : 1;
