// MuJoCo for `score.py --engine`: the scene as `lcpush export --format mjcf` writes it.
//   LCPUSH=build/release/lcpush node tests/engines/mujoco.mjs [step=S] [noslip=N] [timeconst=S] SCENE SECONDS
// step, s (5e-5); noslip iterations (0); time constant of contacts, s (MuJoCo's: 0.02).
// npm install mujoco-js where node finds it (NODE_MODULES names the folder). Prints the motion as CSV.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { performance } from "node:perf_hooks";
import { pathToFileURL } from "node:url";

const words = process.argv.slice(2);
if (words.length < 2 || !process.env.LCPUSH) {
  console.error("LCPUSH has to name the tool: LCPUSH=build/release/lcpush node mujoco.mjs [OPTION ..] SCENE SECONDS");
  process.exit(1);
}
const [scene, seconds] = words.slice(-2);
const { step = "5e-5", noslip = "0", timeconst } = Object.fromEntries(words.slice(0, -2).map((word) => word.split("=")));
const frames = 400;
const folder = mkdtempSync(join(tmpdir(), "mujoco-"));
let xml;
try {
  execFileSync(process.env.LCPUSH, ["export", scene, "--format", "mjcf", "-o", folder], { stdio: "pipe" });
  xml = readFileSync(join(folder, "scene.xml"), "utf8");
} catch (refusal) {
  process.stderr.write(refusal.stderr);
  process.exit(1);
} finally {
  rmSync(folder, { recursive: true });
}
const modules = process.env.NODE_MODULES || "node_modules";
const { default: load } = await import(pathToFileURL(join(modules, "mujoco-js/dist/mujoco_wasm.js")));
const mujoco = await load();
if (timeconst) xml = xml.replaceAll(" condim=", ` solref="${timeconst} 1" condim=`);
mujoco.FS.writeFile("/scene.xml", xml);
const model = mujoco.MjModel.loadFromXML("/scene.xml");
const data = new mujoco.MjData(model);
const steps = Math.max(1, Math.round(+seconds / frames / +step)); // of a frame
model.opt.timestep = +seconds / frames / steps;
model.opt.noslip_iterations = +noslip;
mujoco.mj_resetDataKeyframe(model, data, 0);
mujoco.mj_forward(model, data);
console.log("time,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz");
let spent = 0;
for (let frame = 0; frame <= frames; ++frame) {
  mujoco.mj_forward(model, data); // a step leaves the sensors where it began
  console.log([data.time, ...data.sensordata].join(","));
  const start = performance.now();
  for (let k = 0; k < steps; ++k) mujoco.mj_step(model, data);
  spent += performance.now() - start;
}
console.error(`${((1e3 * spent) / steps / (frames + 1)).toPrecision(3)} us a step`);
