# live_view: connections by the hundred, and orders by the thousand, at the port of the live view.

# A robot and a daemon that waits to be armed, with its live view at $port. start_live_view KEYS: more of live_view.
start_live_view() {
  port=$((20000 + RANDOM % 10000))
  cat > daemon.yaml <<YAML
link: { device: $PWD/robot }
calibration: { when: never, model_file: $PWD/model.yaml }
run:
  arm: by_signal
  at_end: stay
  route: { name: straight, speed: 0.2, checkpoints: [[3, 0]] }
  log_folder: $PWD/runs
real_time: { policy: prefer, lock_memory: false }
live_view: { port: $port$1 }
YAML
  cat > model.yaml <<YAML
wheelwright_model: 1
wheel_base_m: 0.235
period_s: 0.018
encoder_scale: { metres_per_tick_left: 0.000444565, metres_per_tick_right: 0.000444565, ticks_per_turn: 1660, relative_standard_error: 0.002 }
core:
  type: fir
  left: {from_left: [0.0, 0.1, 0.2, 0.3, 0.2, 0.1, 0.1], from_right: [0, 0, 0, 0, 0, 0, 0]}
  right: {from_left: [0, 0, 0, 0, 0, 0, 0], from_right: [0.0, 0.1, 0.2, 0.3, 0.2, 0.1, 0.1]}
YAML
  roomba-sim --config "$source_folder/config/robots/perfect.yaml" --link "$PWD/robot" > robot.txt 2>&1 &
  await '[[ -e robot ]]' || { echo 'no robot'; return 1; }
  wheelwrightd --config daemon.yaml > out.txt 2> err.txt &
  daemon=$!
  await 'grep -q "robot answers" out.txt err.txt' || { echo "no daemon: $(tail -n 1 err.txt)"; return 1; }
}

await() {
  local i
  for ((i = 0; i < 200; ++i)); do
    eval "$1" && return 0
    sleep 0.05
  done
  return 1
}

said() { cat out.txt err.txt | grep -c "$1"; }
memory_kib() { awk '/^VmRSS/ { print $2 }' "/proc/$daemon/status"; }

# status_of TARGET: of the answer to GET; nothing where none came within 2 s.
status_of() {
  local line=
  exec 9<> "/dev/tcp/127.0.0.1/$port" || return
  printf 'GET %s HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n' "$1" >&9
  read -r -t 2 -u 9 line || true
  exec 9>&-
  cut -d ' ' -f 2 <<< "$line"
}

# Opens $1 connections that say nothing, and keeps them open in this shell.
flood() {
  local i fd
  for ((i = 0; i < $1; ++i)); do exec {fd}<> "/dev/tcp/127.0.0.1/$port" || return; done
}

# As a WebSocket on descriptor 8, with the token of the configuration. orders N: N calls of the service /stop.
become_client() {
  exec 8<> "/dev/tcp/127.0.0.1/$port" || return
  printf 'GET /?token=%s HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Protocol: foxglove.sdk.v1\r\n\r\n' "$1" >&8
  local line=
  read -r -t 2 -u 8 line && [[ $line == *" 101 "* ]]
}
orders() {
  local i
  for ((i = 0; i < $1; ++i)); do
    printf '\x82\x93\0\0\0\0\x02\x01\0\0\0\x07\0\0\0\x04\0\0\0json{}'
  done >&8
}

idle_connections() {
  start_live_view ', token: 0123456789abcdef' || return
  kill -USR1 "$daemon"
  await 'grep -q "route: driving" out.txt err.txt' || { echo 'does not drive'; return 1; }
  flood 300 || { echo 'not enough files'; return 77; }
  local status
  status=$(status_of '/?token=0123456789abcdef')
  become_client 0123456789abcdef || { echo 'no WebSocket'; return 1; }
  orders 1
  await 'grep -q "asks for a stop" out.txt err.txt' || { echo 'no stop'; return 1; }
  echo "page: $status, stop taken, $(said 'too many connections') line in the log"
  [[ $status == 200 && $(said 'too many connections') == 1 ]]
}

stop_orders() {
  start_live_view '' || return
  become_client '' || { echo 'no WebSocket'; return 1; }
  cat <&8 > answers &
  orders 5000
  await 'grep -q "more orders to stop" out.txt err.txt' || { echo 'not counted'; return 1; }
  echo "5000 orders: $(said 'to stop\|asks for a stop') lines"
  [[ $(said 'to stop\|asks for a stop') -le 4 ]] && kill -0 "$daemon"
}

# The second flood finds the memory that the first one has given back.
memory_of_floods() {
  start_live_view ', token: 0123456789abcdef' || return
  local first second i
  (flood 600)
  sleep 1
  first=$(memory_kib)
  for ((i = 0; i < 4; ++i)); do (flood 600); done
  sleep 1
  second=$(memory_kib)
  echo "$first kB after one flood of 600 connections, $second kB after five"
  [[ $((second - first)) -lt 512 ]] && kill -0 "$daemon"
}

attack '300 idle connections without a token' 'the page and the stop button answer, one line in the log' idle_connections
attack '5000 orders to stop' 'obeyed, and counted in a few lines' stop_orders
attack 'Floods of connections' 'their memory is used again' memory_of_floods
