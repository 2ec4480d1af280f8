// A mesher of one's own, and its verdict as JSON:  node own_mesher.mjs

import { spawnSync } from "node:child_process";
import { writeFileSync } from "node:fs";

const ring = [[0, 0], [0.3, -0.1], [1, 0], [1.2, 0.7], [0.5, 1.1]];
const triangles = ring.slice(2).map((_, i) => [0, i + 1, i + 2]);
writeFileSync("own.mesh.json", JSON.stringify({ vertices: ring, triangles, polygon: { outer: ring } }));

const run = spawnSync("bern-exact", [
  "verify", "own.mesh.json", "--numbers", "binary64", "--max-angle", "150", "--json",
]);
const verdict = JSON.parse(run.stdout);
console.log(verdict.valid, verdict.max_angle.degrees, verdict.defects.map((d) => d.message));
process.exitCode = run.status; // 0 valid, 1 not, 3 unreadable
