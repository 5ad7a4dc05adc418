import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { setTimeout as wait } from "node:timers/promises";
import { crc32 } from "@foxglove/crc";
import { readByIndex, readFromStart } from "./read.mjs";

const bin = process.env.WHEELWRIGHT_BIN;
const source = process.env.WHEELWRIGHT_SOURCE;
const ticks = 6000;  // 108 s
let folder;
let file;

before(() => {
  folder = mkdtempSync(join(tmpdir(), "wheelwright_mcap_"));
  const drive = ["# wheelwright_drive_log: 1", "# robot: known one", "# wheel_base_m: 0.235", "# period_s: 0.018",
    "# metres_per_tick_left: 0.0004", "# metres_per_tick_right: 0.0004",
    "t,cmd_left,cmd_right,ticks_left,ticks_right,ref_x,ref_y,ref_theta,battery_v,activity,stop"];
  const pose = ["# wheelwright_pose_log: 1", "# pose_source: fir", "t,speed_left,speed_right,x,y,theta,odometry_x,odometry_y,odometry_theta,activity"];
  for (let k = 0; k < ticks; ++k) {
    const t = (0.018 * k).toFixed(6);
    const activity = k < ticks / 2 ? "encoder_turn" : "route";
    drive.push(`${t},0.1,-0.1,${3 * k},${-3 * k},${k % 10 ? ",," : `${k / 1000},2,0.5`},15.5,${activity},${k + 1 < ticks ? "none" : "bump"}`);
    pose.push(`${t},0.09,-0.09,${k / 1000},-1,${Math.PI / 2},0,0,0,${activity}`);
  }
  writeFileSync(join(folder, "drive_log.csv"), drive.join("\n") + "\n");
  writeFileSync(join(folder, "pose_log.csv"), pose.join("\n") + "\n");
  file = join(folder, "run.mcap");
  const status = spawnSync(join(bin, "wheelwright"), ["export", folder, "--mcap", file], { encoding: "utf8" });
  assert.equal(status.status, 0, status.stderr);
});

after(() => rmSync(folder, { recursive: true }));

test("every row of a run is found again by the index, with its numbers", async () => {
  const { reader, messages, metadata } = await readByIndex(file);
  const of = (topic) => messages.filter((message) => message.topic === topic);
  assert.equal(of("/pose/model").length, ticks);
  assert.equal(of("/pose/reference").length, ticks / 10);
  assert.equal(of("/wheels").length, ticks);
  assert.equal(metadata.robot, "known one");
  const pose = of("/pose/model")[1234];
  assert.ok(Math.abs(pose.time_s - 0.018 * 1234) < 1e-9);
  assert.equal(pose.value.frame_id, "route");
  assert.deepEqual(pose.value.timestamp, { sec: 22, nsec: 212000000 });
  assert.deepEqual(pose.value.pose.position, { x: 1.234, y: -1, z: 0 });
  assert.ok(Math.abs(pose.value.pose.orientation.z - Math.SQRT1_2) < 1e-9);
  assert.deepEqual(of("/wheels")[7].value, { timestamp: { sec: 0, nsec: 126000000 },
    left: { command_m_s: 0.1, predicted_m_s: 0.09, ticks: 21 }, right: { command_m_s: -0.1, predicted_m_s: -0.09, ticks: -21 } });
  assert.deepEqual(of("/log").map((message) => message.value.message), ["encoder_turn", "route", "stopped: bump"]);
  assert.equal(reader.statistics.messageCount, BigInt(messages.length));
  for (const [id, count] of reader.statistics.channelMessageCounts) {
    assert.equal(BigInt(of(reader.channelsById.get(id).topic).length), count);
  }
  assert.equal(reader.statistics.chunkCount, reader.chunkIndexes.length);
  assert.ok(reader.chunkIndexes.length > 3);
});

test("a stretch of one topic is found without the rest", async () => {
  const { messages } = await readByIndex(file, { topics: ["/pose/model"], startTime: 90_000_000_000n, endTime: 91_000_000_000n });
  assert.equal(messages.length, 56);  // from 90.000 to 90.990 s
  assert.ok(messages.every((message) => message.topic === "/pose/model"));
});

test("schemas have the well-known names and are JSON Schemas", async () => {
  const { reader } = await readByIndex(file, { topics: [] });
  const schemas = new Map([...reader.schemasById.values()].map((schema) => [schema.name, schema]));
  for (const name of ["foxglove.PoseInFrame", "foxglove.FrameTransform", "foxglove.Log", "wheelwright.Wheels"]) {
    assert.equal(schemas.get(name).encoding, "jsonschema");
    const schema = JSON.parse(new TextDecoder().decode(schemas.get(name).data));
    assert.equal(schema.title, name);
    assert.ok(schema.properties.timestamp);
  }
});

test("the checksum of the data section is that of its bytes", async () => {
  const { reader } = await readByIndex(file, { topics: [] });
  const bytes = readFileSync(file).subarray(0, Number(reader.dataEndOffset));
  assert.equal(reader.dataSectionCrc, crc32(bytes));
});

test("a file that was cut off is readable up to its last whole chunk", async () => {
  const whole = statSync(file).size;
  const all = (await readFromStart(file, whole)).messages.length;
  for (const share of [0.3, 0.6, 0.95]) {
    const { messages, ended } = await readFromStart(file, Math.floor(share * whole));
    assert.equal(ended, false);
    assert.ok(messages.length > (share - 0.25) * all, `${messages.length} of ${all} messages in ${share} of the file`);
  }
});

test("what the daemon writes directly survives that it is killed, but for the last two seconds", async () => {
  const link = join(folder, "robot");
  const config = join(folder, "daemon.yaml");
  writeFileSync(config, `link: {device: ${link}}
calibration: {when: always, model_file: ${join(folder, "model.yaml")}}
run: {route: ${join(source, "config/routes/square.yaml")}, log_folder: ${join(folder, "runs")}, mcap: true}
real_time: {policy: "off"}
`);
  const robot = spawn(join(bin, "roomba-sim"), ["--config", join(source, "config/robots/default.yaml"), "--link", link]);
  let daemon;
  try {
    while (!existsSync(link)) await wait(20);
    daemon = spawn(join(bin, "wheelwrightd"), ["--config", config], { stdio: "ignore" });
    await wait(5000);
  } finally {
    daemon?.kill("SIGKILL");
    robot.kill("SIGTERM");
  }
  const run = join(folder, "runs", readdirSync(join(folder, "runs"))[0]);
  const rows = readFileSync(join(run, "drive_log.csv"), "utf8").split("\n").filter((line) => /^[0-9].*,/.test(line));
  const last_row_s = Number(rows.at(-1).split(",")[0]);
  const recording = join(run, "run.mcap");
  const { messages, ended } = await readFromStart(recording, statSync(recording).size);
  assert.equal(ended, false);
  assert.ok(last_row_s > 2, `the run came as far as ${last_row_s} s`);
  assert.ok(messages.at(-1).time_s > last_row_s - 2, `${messages.at(-1).time_s} s of ${last_row_s} s`);
  assert.ok(messages.some((message) => message.topic === "/sensors" && message.value.light_bumper.length === 6));
});
