// The Foxglove WebSocket protocol, from the client's side. Comes back by itself when the daemon does.
//
//   on.open({name, sessionId, mayControl})   on.message(topic, object, time_s)   on.closed()
class Connection {
  // Only `topics` are asked for.
  constructor(topics, on) {
    this.wanted = topics;
    this.on = on;
    this.calls = new Map();
    this.nextCall = 1;
    this.pause_ms = 500;
    this.open();
  }

  open() {
    const scheme = location.protocol === 'https:' ? 'wss:' : 'ws:';
    const socket = new WebSocket(`${scheme}//${location.host}/${location.search}`, ['foxglove.sdk.v1']);
    socket.binaryType = 'arraybuffer';
    socket.onmessage = event => {
      this.heard_ms = performance.now();
      if (typeof event.data === 'string') this.takeText(JSON.parse(event.data));
      else this.takeBinary(new DataView(event.data));
    };
    socket.onclose = () => this.lost();
    this.socket = socket;
    this.topics = new Map();
    this.stopService = null;
  }

  lost() {
    for (const call of this.calls.values()) call.reject(new Error('the connection was lost'));
    this.calls.clear();
    this.on.closed();
    setTimeout(() => this.open(), this.pause_ms);
    this.pause_ms = Math.min(2 * this.pause_ms, 3000);
  }

  takeText(message) {
    if (message.op === 'serverInfo') {
      this.pause_ms = 500;
      this.on.open({ name: message.name, sessionId: message.sessionId,
                     mayControl: message.capabilities.includes('services') });
    } else if (message.op === 'advertise') {
      const subscriptions = message.channels.filter(channel => this.wanted.has(channel.topic)).map(channel => {
        this.topics.set(channel.id, channel.topic);
        return { id: channel.id, channelId: channel.id };
      });
      this.socket.send(JSON.stringify({ op: 'subscribe', subscriptions }));
    } else if (message.op === 'advertiseServices') {
      this.stopService = message.services.find(service => service.name === '/stop') || null;
    } else if (message.op === 'serviceCallFailure') {
      this.settle(message.callId, call => call.reject(new Error(message.message)));
    }
  }

  takeBinary(view) {
    const opcode = view.getUint8(0);
    if (opcode === 1) {
      const payload = new Uint8Array(view.buffer, 13);
      const time_s = Number(view.getBigUint64(5, true)) * 1e-9;
      this.on.message(this.topics.get(view.getUint32(1, true)), JSON.parse(decoder.decode(payload)), time_s);
    } else if (opcode === 3) {
      this.settle(view.getUint32(5, true), call => call.resolve());
    }
  }

  settle(id, how) {
    const call = this.calls.get(id);
    this.calls.delete(id);
    if (call) how(call);
  }

  // Resolves once the daemon has taken the order.
  stop() {
    return new Promise((resolve, reject) => {
      if (!this.stopService || this.socket.readyState !== WebSocket.OPEN) {
        reject(new Error('there is no connection'));
        return;
      }
      const id = this.nextCall++;
      this.calls.set(id, { resolve, reject });
      const encoding = encoder.encode('json');
      const body = encoder.encode('{}');
      const bytes = new Uint8Array(13 + encoding.length + body.length);
      const view = new DataView(bytes.buffer);
      view.setUint8(0, 2);
      view.setUint32(1, this.stopService.id, true);
      view.setUint32(5, id, true);
      view.setUint32(9, encoding.length, true);
      bytes.set(encoding, 13);
      bytes.set(body, 13 + encoding.length);
      this.socket.send(bytes);
    });
  }
}

const encoder = new TextEncoder();
const decoder = new TextDecoder();
