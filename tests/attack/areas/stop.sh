# A stop is obeyed, whatever has become of standard error, the terminal, the guardian, and the files of the daemon.

longest_ms=300
# A sensor loop that hangs is noticed after three periods, without real-time scheduling after link.blind_limit_s.
longest_stall_ms=550

now_ms() { date +%s%3N; }

# until SECONDS COMMAND...: repeats it until it succeeds.
until_true() {
  local end=$((SECONDS + $1))
  shift
  until "$@"; do
    ((SECONDS < end)) || return 1
    sleep 0.02
  done
}

phase_is() { grep -q "\"phase\": \"$1" status.json 2>/dev/null; }

# start_robot: the simulated robot, on the device ./robot.
start_robot() {
  roomba-sim --config "$source_folder/config/robots/default.yaml" --link "$PWD/robot" --truth truth.csv >robot.out 2>&1 &
  robot=$!
  until_true 5 test -L robot
  cp "$source_folder/tests/booted/model.yaml" model.yaml
  cat >daemon.yaml <<YAML
link: {device: $PWD/robot}
calibration: {when: never, model_file: $PWD/model.yaml}
run:
  route: {name: far, speed: 0.2, tolerance: 0.02, checkpoints: [[3, 0]]}
  at_end: stay
  log_folder: $PWD/runs
real_time: {lock_memory: false}
live_view: {port: 0}
YAML
}

# drives: waits until the robot goes at speed.
drives() {
  until_true 15 phase_is route || { echo "the robot does not drive"; return 1; }
  sleep 1.5
}

start_daemon() { wheelwrightd --config daemon.yaml --status status.json "$@" >daemon.out 2>daemon.err & daemon=$!; drives; }

# Nobody reads this pipe, and it is full.
start_unread_daemon() {
  mkfifo unread
  exec 9<>unread
  # The writer waits once the pipe is full.
  (exec 9<&-; while :; do printf '%04096d' 0; done >unread) 2>/dev/null &
  sleep 0.3
  wheelwrightd --config daemon.yaml --status status.json >daemon.out 2>unread &
  daemon=$!
  drives
}

# rests_after MS LIMIT: ends the robot, and says how long after a moment its wheels were at rest.
rests_after() {
  sleep 0.6
  kill -TERM "$robot"
  wait "$robot" 2>/dev/null
  awk -F, -v at="$1" -v limit="$2" '
    /^# started_unix_ms/ { sub(/.*: /, ""); started = $0; next }
    /^#/ { next }
    !t { for (i = 1; i <= NF; ++i) column[$i] = i; t = column["t"]; l = column["speed_left"]; r = column["speed_right"]; next }
    { ms = started + 1000 * $t - at; if (ms < 0) before = $l; if ($l > 0.001 || $l < -0.001 || $r > 0.001 || $r < -0.001) last = ms }
    END {
      printf "%.2f m/s before, wheels at rest after %d ms\n", before, last
      exit !(before > 0.15 && last < limit)
    }' truth.csv
}

ends_within() { until_true "$1" eval '! kill -0 "$daemon" 2>/dev/null' || { echo "the process does not end"; return 1; }; }

unread_sigterm() {
  start_robot && start_unread_daemon || return 1
  kill -HUP "$daemon"
  local at; at=$(now_ms)
  kill -TERM "$daemon"
  ends_within 8 && rests_after "$at" $longest_ms
}

unread_sigusr2() {
  start_robot && start_unread_daemon || return 1
  kill -HUP "$daemon"
  local at; at=$(now_ms)
  kill -USR2 "$daemon"
  rests_after "$at" $longest_ms
}

unread_hang() {
  start_robot && start_unread_daemon || return 1
  local at; at=$(now_ms)
  kill -STOP "$daemon"
  rests_after "$at" $longest_stall_ms
}

unread_kill() {
  start_robot && start_unread_daemon || return 1
  local at; at=$(now_ms)
  kill -KILL "$daemon"
  rests_after "$at" $longest_ms
}

held_terminal_sigterm() {
  command -v script >/dev/null || { echo "script (package bsdutils) is not installed"; return 77; }
  start_robot
  mkfifo keys
  exec 8<>keys
  env --default-signal=HUP script -qec "wheelwrightd --config daemon.yaml --status status.json" /dev/null <keys >terminal 2>&1 &
  drives || return 1
  daemon=$(pgrep -f "wheelwrightd --config daemon.yaml" | while read -r pid; do
    [[ $(readlink "/proc/$pid/cwd") == "$PWD" && $(<"/proc/$pid/comm") == wheelwrightd ]] && echo "$pid"; done | head -n 1)
  printf '\023' >&8
  sleep 0.2
  kill -USR1 "$daemon"
  local at; at=$(now_ms)
  kill -TERM "$daemon"
  ends_within 8 && rests_after "$at" $longest_ms
}

closed_terminal() {
  command -v script >/dev/null || { echo "script (package bsdutils) is not installed"; return 77; }
  start_robot
  mkfifo keys
  exec 8<>keys
  env --default-signal=HUP script -qec "wheelwrightd --config daemon.yaml --status status.json" /dev/null <keys >terminal 2>&1 &
  local terminal=$!
  drives || return 1
  local at; at=$(now_ms)
  kill -KILL "$terminal"
  rests_after "$at" $longest_ms
}

stopped_guardian() {
  start_robot && start_daemon || return 1
  local guardian; guardian=$(pgrep -P "$daemon")
  kill -STOP "$guardian"
  ends_within 5 || return 1
  ! kill -0 "$guardian" 2>/dev/null || { echo "the guardian is still there"; return 1; }
  rests_after "$(now_ms)" 1 | sed 's/^.*m\/s before/the daemon ended itself/'
  [[ $(tail -n 1 truth.csv | awk -F, '{ print $5 == 0 }') ]] && grep -q "guardian process stands still" daemon.out
}

stopped_guardian_sigterm() {
  start_robot && start_daemon || return 1
  kill -STOP "$(pgrep -P "$daemon")"
  local at; at=$(now_ms)
  kill -TERM "$daemon"
  ends_within 8 && rests_after "$at" $longest_ms
}

rest_with_spoiled_configuration() {
  start_robot
  mkdir runtime state
  export RUNTIME_DIRECTORY=$PWD/runtime STATE_DIRECTORY=$PWD/state
  start_daemon --service || return 1
  kill -KILL "$(pgrep -P "$daemon")" "$daemon"
  printf '\t[\n' >daemon.yaml
  local at; at=$(now_ms)
  wheelwrightd --service --rest --config daemon.yaml 2>rest.err || { cat rest.err; return 1; }
  rests_after "$at" $longest_ms
}

armed_after_power_cut() {
  start_robot
  mkdir runtime state
  export RUNTIME_DIRECTORY=$PWD/runtime STATE_DIRECTORY=$PWD/state
  start_daemon --service || return 1
  kill -KILL "$daemon"
  sleep 1
  rm -r runtime status.json
  mkdir runtime
  wheelwrightd --service --config daemon.yaml --status status.json >daemon.out 2>daemon.err &
  until_true 10 grep -q 'not armed' daemon.err && grep -m 1 -o 'not armed.*' daemon.err
}

processor_time() {
  start_robot && start_daemon || return 1
  local at; at=$(now_ms)
  kill -XCPU "$daemon"
  ends_within 5 && grep -q "a limit of processor time is reached" daemon.out && rests_after "$at" $longest_ms
}

file_size() {
  start_robot
  sed -i 's/\[\[3, 0\]\]/[[0.3, 0]]/; s/at_end: stay/at_end: exit/' daemon.yaml
  (ulimit -f 16; exec wheelwrightd --config daemon.yaml) >daemon.out 2>daemon.err
  local status=$?
  grep -o '[a-z]*_log.csv: .*' daemon.err | head -n 1
  [[ $status == 1 ]] && grep -q "Result: finished" daemon.out && grep -q "cannot be written: File too large" daemon.err
}

attack "standard error that nobody reads, SIGTERM" "wheels at rest within $longest_ms ms, and the process ends" unread_sigterm
attack "standard error that nobody reads, SIGUSR2" "wheels at rest within $longest_ms ms" unread_sigusr2
attack "standard error that nobody reads, SIGSTOP" "wheels at rest within $longest_stall_ms ms by the guardian" unread_hang
attack "standard error that nobody reads, SIGKILL" "wheels at rest within $longest_ms ms by the guardian" unread_kill
attack "a terminal held by Ctrl-S, SIGTERM" "wheels at rest within $longest_ms ms, and the process ends" held_terminal_sigterm
attack "the terminal is closed" "wheels at rest within $longest_ms ms" closed_terminal
attack "the guardian is stopped" "the daemon stops the robot and ends, with its guardian" stopped_guardian
attack "the guardian is stopped, SIGTERM" "wheels at rest within $longest_ms ms, and the process ends" stopped_guardian_sigterm
attack "a spoiled configuration, --rest" "wheels at rest within $longest_ms ms" rest_with_spoiled_configuration
attack "a power cut while armed" "the next process does not arm the robot by itself" armed_after_power_cut
attack "a limit of processor time" "wheels at rest within $longest_ms ms, and a sentence" processor_time
attack "a limit of file size" "the route is driven to its end, the file is named, exit status 1" file_size
