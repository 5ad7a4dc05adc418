import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import rosmsg from "@foxglove/rosmsg";
import { MessageWriter as Ros1Writer } from "@foxglove/rosmsg-serialization";
import rosmsg2 from "@foxglove/rosmsg2-serialization";
import zstd from "@foxglove/wasm-zstd";
import { McapWriter, TempBuffer } from "@mcap/core";

const odometry = (header) => `Header header
string child_frame_id
Pose pose
float64[36] covariance
string[] name
float32[] effort
uint8[] image
bool on
===
MSG: std_msgs/Header
${header}
===
MSG: geometry_msgs/Pose
geometry_msgs/Point position
===
MSG: geometry_msgs/Point
float64 x
float64 y
`;
const ros1_text = odometry("uint32 seq\ntime stamp\nstring frame_id");
const ros2_text = odometry("builtin_interfaces/Time stamp\nstring frame_id") +
  "===\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n";
const value = (k, stamp) => ({
  header: { seq: k, stamp, frame_id: "odom" }, child_frame_id: "x".repeat(k % 7),
  pose: { position: { x: k / 8, y: -k } }, covariance: new Array(36).fill(1), name: ["left", "right"],
  effort: [k, 0.5], image: new Uint8Array(1000), on: k % 2 === 1,
});
const count = 500;
let folder;

before(async () => {
  await zstd.isLoaded;
  folder = mkdtempSync(join(tmpdir(), "wheelwright_bags_"));
});
after(() => rmSync(folder, { recursive: true }));

async function write(name, { profile, messageEncoding, schemaEncoding, type, text, encode, options }) {
  const buffer = new TempBuffer();
  const writer = new McapWriter({ writable: buffer, ...options });
  await writer.start({ profile, library: "" });
  const schemaId = await writer.registerSchema({ name: type, encoding: schemaEncoding, data: new TextEncoder().encode(text) });
  const channelId = await writer.registerChannel({ schemaId, topic: "/odom", messageEncoding, metadata: new Map() });
  for (let k = 0; k < count; ++k) {
    const time = 1_700_000_000_000_000_000n + BigInt(k) * 20_000_000n;
    await writer.addMessage({ channelId, sequence: k, logTime: time, publishTime: time, data: encode(k) });
  }
  await writer.end();
  const path = join(folder, name);
  writeFileSync(path, buffer.get());
  return path;
}

function read(path) {
  const status = spawnSync(process.env.RECORDING_JSON, [path], { encoding: "utf8", maxBuffer: 1 << 28 });
  assert.equal(status.status, 0, status.stderr);
  return JSON.parse(status.stdout);
}

function check(recording) {
  const stream = recording.streams["/odom"];
  assert.equal(stream.not_decoded, "");
  assert.equal(stream.type, "nav_msgs/Odometry");
  assert.equal(stream.received_s.length, count);
  const { channels } = stream;
  assert.ok(!Object.keys(channels).some((name) => name.startsWith("covariance") || name.startsWith("image")));
  for (let k = 0; k < count; ++k) {
    assert.ok(Math.abs(stream.received_s[k] - (1_700_000_000 + 0.02 * k)) < 1e-6);
    assert.equal(channels["header.stamp"][k], k + 0.5);
    assert.equal(channels["pose.position.x"][k], k / 8);
    assert.equal(channels["pose.position.y"][k], -k);
    assert.equal(channels["effort[left]"][k], k);
    assert.equal(channels["effort[right]"][k], 0.5);
    assert.equal(channels.on[k], k % 2);
  }
}

const compressChunk = (bytes) => ({ compression: "zstd", compressedData: zstd.compress(bytes) });
const dressings = {
  "without chunks or index": { useChunks: false, useSummaryOffsets: false, useStatistics: false, useMessageIndex: false, repeatChannels: false, repeatSchemas: false },
  "in chunks": { chunkSize: 20_000 },
  "in chunks of zstd": { chunkSize: 20_000, compressChunk },
};

for (const [name, options] of Object.entries(dressings)) {
  test(`messages of ROS 2 by another writer are read, ${name}`, async () => {
    const writer = new rosmsg2.MessageWriter(rosmsg.parse(ros2_text, { ros2: true }));
    const encode = (k) => writer.writeMessage(value(k, { sec: k, nsec: 500_000_000 }));
    check(read(await write("ros2.mcap", { profile: "ros2", messageEncoding: "cdr", schemaEncoding: "ros2msg",
      type: "nav_msgs/msg/Odometry", text: ros2_text, encode, options })));
  });
  test(`messages of ROS 1 by another writer are read, ${name}`, async () => {
    const writer = new Ros1Writer(rosmsg.parse(ros1_text));
    const encode = (k) => writer.writeMessage(value(k, { sec: k, nsec: 500_000_000 }));
    check(read(await write("ros1.mcap", { profile: "ros1", messageEncoding: "ros1", schemaEncoding: "ros1msg",
      type: "nav_msgs/Odometry", text: ros1_text, encode, options })));
  });
}
