// The live view as @foxglove/ws-protocol sees it, the client that Foxglove and Lichtblick are made with.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { eventually, onBench, sleep } from './bench.mjs';

const require = createRequire(import.meta.url);
const { FoxgloveClient } = require('@foxglove/ws-protocol');
const WebSocket = require('ws');

function connect(bench, subprotocol) {
  const client = new FoxgloveClient({ ws: new WebSocket(bench.url.replace('http', 'ws'), [subprotocol]) });
  const seen = { topics: new Map(), messages: new Map(), services: [], errors: [] };
  client.on('serverInfo', info => { seen.info = info; });
  client.on('error', error => seen.errors.push(String(error)));
  client.on('status', status => seen.errors.push(status.message));
  client.on('advertiseServices', services => seen.services.push(...services));
  client.on('advertise', channels => {
    for (const channel of channels) seen.topics.set(client.subscribe(channel.id), channel);
  });
  client.on('message', ({ subscriptionId, timestamp, data }) => {
    const { topic } = seen.topics.get(subscriptionId);
    if (!seen.messages.has(topic)) seen.messages.set(topic, []);
    seen.messages.get(topic).push({ timestamp, message: JSON.parse(new TextDecoder().decode(data)) });
  });
  return { client, seen };
}

// What is wrong with a value by a JSON Schema of the kind that the daemon sends; null for a number that is not known.
function misfit(schema, value, at = '') {
  if (value === null && schema.type === 'number') return '';
  const type = Array.isArray(value) ? 'array' : typeof value;
  if (schema.type !== type && !(schema.type === 'integer' && Number.isInteger(value))) return `${at} is ${type}, not ${schema.type}`;
  if (type === 'array') return value.map((item, i) => misfit(schema.items, item, `${at}[${i}]`)).find(Boolean) || '';
  if (type !== 'object' || !schema.properties) return '';
  const unknown = Object.keys(value).find(key => !schema.properties[key]);
  if (unknown) return `${at}.${unknown} is not in the schema`;
  return Object.keys(value).map(key => misfit(schema.properties[key], value[key], `${at}.${key}`)).find(Boolean) || '';
}

for (const subprotocol of ['foxglove.websocket.v1', 'foxglove.sdk.v1']) {
  test(`by ${subprotocol} every channel comes at its rate and by its schema, and the service stops the robot`, () => onBench({}, async bench => {
    await bench.startDaemon();
    await eventually('the robot drives', () => bench.daemon.said.includes('route: driving'));
    const { client, seen } = connect(bench, subprotocol);
    await eventually('the service is offered', () => seen.services.length);
    await sleep(1500);
    const begun = new Map([...seen.messages].map(([topic, list]) => [topic, list.length]));
    await sleep(2000);
    assert.deepEqual(seen.errors, []);
    assert.equal(seen.info.name, 'test robot');
    for (const channel of seen.topics.values()) {
      const list = seen.messages.get(channel.topic) ?? [];
      assert.ok(list.length, `nothing came on ${channel.topic}`);
      for (const { message } of list) assert.equal(misfit(JSON.parse(channel.schema), message, channel.topic), '');
      const rate_hz = (list.length - begun.get(channel.topic)) / 2;
      const least_hz = { '/log': 0, '/scene': 2, '/state': 1 }[channel.topic] ?? 0.6 / 0.018;
      assert.ok(rate_hz >= least_hz, `${channel.topic} came at ${rate_hz} Hz`);
    }
    const poses = seen.messages.get('/pose');
    const now_ns = BigInt(Date.now()) * 1000000n;
    assert.ok(now_ns - poses.at(-1).timestamp < 1000000000n, 'a pose is older than a second');
    for (let i = 1; i < poses.length; ++i) assert.ok(poses[i].timestamp > poses[i - 1].timestamp, 'poses out of order');

    const answered = new Promise(resolve => client.on('serviceCallResponse', resolve));
    client.sendServiceCallRequest({ serviceId: seen.services[0].id, callId: 1, encoding: 'json',
                                    data: new DataView(new TextEncoder().encode('{}').buffer) });
    const answer = await answered;
    assert.deepEqual(JSON.parse(new TextDecoder().decode(answer.data)), { stopped: true });
    assert.equal(await bench.daemon.ended, 1);
    assert.match(bench.daemon.said, /Result: stopped, requested/);
    for (const speed of await bench.trueSpeedAtEnd()) assert.ok(Math.abs(speed) < 1e-4, `a wheel turns at ${speed} m/s`);
  }));
}
