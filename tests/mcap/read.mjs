// What @mcap/core makes of a file: all of it by its index, or as much as there is from start to end.
import { open, readFile } from "node:fs/promises";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { decompress } from "fzstd";

const decompressHandlers = { zstd: (bytes) => decompress(bytes) };

async function readable(path) {
  const file = await open(path);
  return {
    size: async () => BigInt((await file.stat()).size),
    read: async (offset, size) => {
      const bytes = new Uint8Array(Number(size));
      await file.read(bytes, 0, Number(size), Number(offset));
      return bytes;
    },
    close: () => file.close(),
  };
}

const decode = (data) => JSON.parse(new TextDecoder().decode(data));

// { reader, messages: [{ topic, time_s, value }] } in the order of time, as the index has it.
export async function readByIndex(path, query = {}) {
  const file = await readable(path);
  const reader = await McapIndexedReader.Initialize({ readable: file, decompressHandlers });
  const messages = [];
  for await (const message of reader.readMessages({ validateCrcs: true, ...query })) {
    const { topic } = reader.channelsById.get(message.channelId);
    messages.push({ topic, time_s: Number(message.logTime) / 1e9, value: decode(message.data) });
  }
  const metadata = {};
  for await (const record of reader.readMetadata()) Object.assign(metadata, Object.fromEntries(record.metadata));
  await file.close();
  return { reader, messages, metadata };
}

// The messages of a file's first `length` bytes.
export async function readFromStart(path, length) {
  const reader = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  reader.append((await readFile(path)).subarray(0, length));
  const topics = new Map();
  const messages = [];
  for (let record; (record = reader.nextRecord()); ) {
    if (record.type === "Channel") topics.set(record.id, record.topic);
    if (record.type !== "Message") continue;
    messages.push({ topic: topics.get(record.channelId), time_s: Number(record.logTime) / 1e9, value: decode(record.data) });
  }
  return { messages, ended: reader.done() };
}
