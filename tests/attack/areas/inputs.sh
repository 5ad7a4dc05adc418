# Files that are none, have no end, cannot be read, or are made to cost much; and text in them that a terminal would
# obey.

inputs_log_head='# wheelwright_drive_log: 1
# wheel_base_m: 0.258
# period_s: 0.018
# metres_per_tick_left: 0.000444
# metres_per_tick_right: 0.000444'

inputs_model() {
  cat <<'END'
wheelwright_model: 1
wheel_base_m: 0.258
period_s: 0.018
core:
  type: fir
  left: {from_left: [0.0, 1.0], from_right: [0, 0]}
  right: {from_left: [0, 0], from_right: [0.0, 1.0]}
END
}

inputs_log() { # [ROWS]
  echo "$inputs_log_head"
  echo t,cmd_left,cmd_right,ticks_left,ticks_right
  awk -v rows="${1:-300}" 'BEGIN { for (i = 0; i < rows; ++i) printf "%.3f,0.1,0.1,%d,%d\n", i * 0.018, i * 4, i * 4 }'
}

# Every reader of a file, once: the name of the file comes in the place of @. Each gets 20 s and 1 GB.
inputs_commands=(
  "wheelwright score @ log.csv" "wheelwright score model.yaml @" "wheelwright fit @ -o fit.yaml"
  "wheelwright simulate model.yaml @ -o out.csv" "wheelwright gap --train @ -o gap" "wheelwright report @ -o report.html"
  "wheelwright report log.csv --truth @ -o report.html" "wheelwright export @ --tum out.tum"
  "wheelwright import mrclam @ @ -o log2.csv" "wheelwright replay @ --config @" "wheelwright status @"
  "wheelwright doctor --config @" "wheelwrightd --config @ --check" "wheelwrightd --config daemon.yaml --commands @ --check"
  "roomba-sim --config @" "roomba-sim --room @" "roomba-sim --replay @")

inputs_start() {
  inputs_model >model.yaml
  inputs_log >log.csv
  printf 'run: {route: route.yaml}\n' >daemon.yaml
  printf 'name: r\ncheckpoints: [[1, 0]]\n' >route.yaml
}

# refused_by_all FILE SENTENCE: each program refuses FILE in one line that names it and holds SENTENCE.
inputs_refused_by_all() {
  local command line status fell=0
  for command in "${inputs_commands[@]}"; do
    line=$( (ulimit -v 1000000; timeout 20 ${command//@/$1} </dev/null 2>&1 >/dev/null)) && status=0 || status=$?
    [[ $status == [12] && $line == *"$1: "*$2* && $line != *$'\n'* ]] && continue
    fell=$((fell + 1))
    echo "exit $status of '$command': $line"
  done
  ((fell == 0)) && echo "${#inputs_commands[@]} readers refuse it by its name"
}

device() { inputs_start; inputs_refused_by_all /dev/zero "is a device"; }
attack "/dev/zero as every kind of file" "a sentence that names it" device

named_pipe() { inputs_start; mkfifo pipe; inputs_refused_by_all pipe "is a named pipe"; }
attack "a named pipe as every kind of file" "no hang, a sentence that names it" named_pipe

large_file() { inputs_start; truncate -s 2G large; inputs_refused_by_all large "2048.0 MiB"; }
attack "2 GiB as every kind of file" "a sentence that names it and the limit" large_file

folder() { inputs_start; mkdir folder; inputs_refused_by_all folder/ ""; }
attack "a folder as every kind of file" "a sentence that names it" folder

read_error() { inputs_start; inputs_refused_by_all /proc/self/mem "Input/output error"; }
attack "a file whose first read fails" "a sentence that names it" read_error

# A read of a file called bad.* fails after its first BAD_AFTER bytes, as on a worn memory card.
inputs_make_bad_reads() {
  command -v cc >/dev/null || { echo "no compiler"; return 77; }
  cat >bad.c <<'END'
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
ssize_t read(int descriptor, void* to, size_t size) {
  ssize_t (*real)(int, void*, size_t) = (ssize_t (*)(int, void*, size_t))dlsym(RTLD_NEXT, "read");
  char link[64], name[4096];
  snprintf(link, sizeof(link), "/proc/self/fd/%d", descriptor);
  ssize_t length = readlink(link, name, sizeof(name) - 1);
  if (length > 0) {
    name[length] = 0;
    if (strstr(name, "/bad.") != NULL) {
      off_t at = lseek(descriptor, 0, SEEK_CUR);
      off_t end = atol(getenv("BAD_AFTER"));
      if (at >= end) { errno = EIO; return -1; }
      if (size > (size_t)(end - at)) size = (size_t)(end - at);
    }
  }
  return real(descriptor, to, size);
}
END
  cc -shared -fPIC -o bad.so bad.c -ldl || { echo "no compiler"; return 77; }
}

bad_model() {
  inputs_make_bad_reads || return
  inputs_log >log.csv
  { inputs_model; echo 'effects: [{name: dead_zone, parameters: {threshold: 0.02}}]'; } >bad.yaml
  local line status
  line=$(BAD_AFTER=$(inputs_model | wc -c) LD_PRELOAD=./bad.so wheelwright score bad.yaml log.csv 2>&1) && status=0 || status=$?
  echo "exit $status: $line"
  [[ $status == 2 && $line == *"bad.yaml: cannot be read to its end: Input/output error"* ]]
}
attack "a read error in the middle of model.yaml" "no model without its effects" bad_model

bad_log() {
  inputs_make_bad_reads || return
  inputs_model >model.yaml
  inputs_log >bad.csv
  local line status
  line=$(BAD_AFTER=200 LD_PRELOAD=./bad.so wheelwright score model.yaml bad.csv 2>&1) && status=0 || status=$?
  echo "exit $status: $line"
  [[ $status == 2 && $line == *"bad.csv: cannot be read to its end: Input/output error"* ]]
}
attack "a read error in the middle of a log" "that, and no advice to delete its last row" bad_log

shell_pipe() {
  inputs_start
  local out
  out=$(wheelwright score model.yaml <(cat log.csv) --json) || { echo "exit $?"; return 1; }
  echo "read: ${out:0:60}"
  out=$(ulimit -v 4000000; timeout 60 wheelwright score <(yes 'a: b') log.csv 2>&1) && return 1
  echo "a log is read; without end: $out"
  [[ $out == *"longer than the 8 MiB"* ]]
}
attack "a pipe of the shell" "it is read, as far as the limit" shell_pipe

# costs_little FILE COMMAND...: ends within 10 s and 500 MB, with a sentence that names FILE.
inputs_costs_little() {
  local file=$1 line status start=$EPOCHREALTIME
  shift
  line=$( (ulimit -v 500000; timeout 10 "$@" 2>&1 >/dev/null)) && status=0 || status=$?
  printf '%.1f s, exit %d: %s\n' "$(awk -v a="$start" -v b="$EPOCHREALTIME" 'BEGIN { print b - a }')" "$status" "${line:0:150}"
  [[ $status == 2 && $line == *"$file:"* && ${#line} -lt 500 ]]
}

many_keys() { awk 'BEGIN { for (i = 0; i < 100000; ++i) print "key" i ": 1" }' >a.yaml; inputs_costs_little a.yaml roomba-sim --room a.yaml; }
attack "100 000 keys" "a sentence within seconds" many_keys

many_coefficients() {
  inputs_log >log.csv
  { echo 'wheelwright_model: 1'; printf 'core: {left: {from_left: ['; awk 'BEGIN { for (i = 0; i < 1000000; ++i) printf "0.5, " }'; echo ']}}'; } >a.yaml
  inputs_costs_little a.yaml wheelwright score a.yaml log.csv
}
attack "1 000 000 coefficients" "a sentence within seconds" many_coefficients

many_columns() {
  inputs_model >model.yaml
  { echo "$inputs_log_head"; awk 'BEGIN { printf "t,cmd_left,cmd_right"; for (i = 0; i < 60000; ++i) printf ",c%d", i; printf "\n0,0" }'; echo; } >a.csv
  inputs_costs_little a.csv wheelwright score model.yaml a.csv
}
attack "60 000 columns" "a sentence within seconds" many_columns

many_runs() {
  inputs_model >model.yaml
  { echo "$inputs_log_head"; awk 'BEGIN { for (i = 0; i < 20000; ++i) print "# note" i ": x"; print "t,cmd_left,cmd_right"
      for (i = 0; i < 5000; ++i) print "0,0,0\n0.018,0,0" }'; } >a.csv
  inputs_costs_little a.csv wheelwright score model.yaml a.csv
}
attack "5 000 runs under 20 000 lines of metadata" "a sentence within seconds" many_runs

long_line() {
  inputs_model >model.yaml
  { echo "$inputs_log_head"; echo t,cmd_left,cmd_right; head -c 50000000 /dev/zero | tr '\0' x; echo ,0,0; } >a.csv
  inputs_costs_little a.csv wheelwright score model.yaml a.csv
}
attack "a field of 50 MB" "a sentence that quotes little of it" long_line

deep() { head -c 100000 /dev/zero | tr '\0' '[' >a.yaml; inputs_costs_little a.yaml wheelwrightd --config a.yaml --check; }
attack "YAML of 100 000 levels" "a sentence" deep

aliases() {
  local before=a name
  echo 'a: &a [x, x, x, x, x, x, x, x, x]' >a.yaml
  for name in b c d e f g h i; do
    echo "$name: &$name [*$before, *$before, *$before, *$before, *$before, *$before, *$before, *$before, *$before]" >>a.yaml
    before=$name
  done
  inputs_costs_little a.yaml wheelwrightd --config a.yaml --check
}
attack "aliases that stand for 400 million values" "a sentence" aliases

deep_status() {
  { echo '{"wheelwright_status": 1, "x": '; head -c 2000000 /dev/zero | tr '\0' '['; head -c 2000000 /dev/zero | tr '\0' ']'; echo '}'; } >a.json
  inputs_costs_little a.json wheelwright status a.json --json
}
attack "a status file of 2 000 000 levels" "a sentence" deep_status

# What moves a cursor, sets a title, ends a line early or turns the direction of writing, in several encodings.
inputs_evil=$'\e]0;title\a\e[2J\r\x7f\xc2\x9b31m\xe2\x80\xae\xff'

# Nothing that a terminal obeys stands in FILE.
inputs_is_harmless() {
  local bad='[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]|\xd8\x9c|\xe2\x80[\x8e\x8f\xa8-\xae]|\xe2\x81[\xa6-\xa9]|\xff'
  ! LC_ALL=C grep -qP "$bad" "$1" || { echo "reaches the terminal: $(LC_ALL=C grep -P "$bad" "$1" | cat -v | head -n 1)"; return 1; }
}

evil_errors() {
  inputs_start
  local evil=$inputs_evil count=0 status
  { echo "$inputs_log_head"; echo t,cmd_left,cmd_right; echo "$evil,0,0"; echo 1,0,0; } >cell.csv
  { echo "$inputs_log_head"; echo "t,cmd_left,cmd_right,$evil,$evil"; echo 0,0,0,1,1; } >column.csv
  { echo "# wheelwright_drive_log: $evil"; echo t,cmd_left,cmd_right; echo 0,0,0; } >version.csv
  { echo "t,x,y,theta"; echo "0,0,$evil,0"; } >pose.csv
  echo "1 $evil 3" >odometry.dat
  printf '"\\e]0;key\\a\\u009b\\u202e": 1\n' >key.yaml
  printf 'period_s: "\\e]0;value\\a\\u009b\\u202e"\nlink: {period_s: "\\e[2J\\r"}\n' >value.yaml
  cp log.csv "$evil.csv"
  while read -r -d '' command; do
    bash -c "$command" >out 2>&1 </dev/null && status=0 || status=$?
    inputs_is_harmless out || { echo "by $(cat -v <<<"$command")"; return 1; }
    [[ $status != 0 && -s out ]] || { echo "exit $status of $(cat -v <<<"$command"): $(head -n 1 out)"; return 1; }
    count=$((count + 1))
  done < <(printf '%s\0' \
    "wheelwright score model.yaml cell.csv" "wheelwright score model.yaml column.csv" "wheelwright fit version.csv -o x" \
    "wheelwright export pose.csv --tum x" "wheelwright import mrclam odometry.dat odometry.dat -o x" \
    "wheelwright score key.yaml log.csv" "wheelwright score value.yaml log.csv" "wheelwright doctor --config value.yaml" \
    "wheelwright simulate model.yaml '$evil' -o x" "wheelwright fit '$evil.csv' -o x" "wheelwright '$evil'" \
    "wheelwright score --'$evil'" "wheelwright effects '$evil'" "wheelwright status '$evil'" "wheelwright circle --seed '$evil' -o x" \
    "wheelwrightd --config key.yaml --check" "wheelwrightd --config value.yaml --check" "wheelwrightd --config '$evil'" \
    "wheelwrightd --'$evil'" "wheelwrightd --service --config key.yaml" "roomba-sim --config key.yaml" "roomba-sim --room value.yaml" \
    "roomba-sim --'$evil'" "roomba-sim --replay cell.csv" "roomba-sim --seed '$evil'" "serial-faults --robot '$evil' --link x" \
    "serial-faults --'$evil'" "serial-faults --robot x --link y --kinds '$evil'")
  echo "$count errors hold no control character"
}
attack "escape sequences in cells, names, keys, values, options" "escaped in every error line" evil_errors

evil_tables() {
  inputs_start
  cp log.csv "$inputs_evil.csv"
  wheelwright score model.yaml "$inputs_evil.csv" >table || return
  wheelwright score model.yaml "$inputs_evil.csv" --json >json || return
  inputs_is_harmless table && inputs_is_harmless json || return
  ! command -v python3 >/dev/null || python3 -c 'import json; json.load(open("json"))' || return
  tail -n 1 table | cut -c 1-100
}
attack "escape sequences in a file's name, in a table and in JSON" "escaped, and the JSON still JSON" evil_tables

evil_status() {
  local text='\u001b]0;title\u0007\u001b[2J\u009b31m\u202e\r\n\u007f'
  local loop='{"system": "'$text'", "ticks": 1, "period_s": 0.018, "overruns": 0, "skipped_periods": 0, "commands_late": 0,
    "lateness_us": {"p50": 1, "p99": 1, "largest": 1, "histogram": []}}'
  echo '{"wheelwright_status": 1, "pid": '$$', "robot": "'$text'", "device": "'$text'", "phase": "'$text'", "run_folder": "'$text'",
    "time": "'$text'", "loop": '"$loop"'}' >status.json
  wheelwright status status.json >out || return
  wheelwright status status.json --json >json || return
  inputs_is_harmless out && inputs_is_harmless json && head -n 1 out
}
attack "escape sequences in a status file" "escaped, as a table and as JSON" evil_status

evil_daemon() {
  printf 'robot: {name: "\\e]0;name\\a\\u009b"}\nlink: {device: "/dev/none\\e[2J\\r\\u202e"}\nrun: {log_folder: runs}\n' >daemon.yaml
  timeout 10 wheelwrightd --config daemon.yaml >out 2>&1
  inputs_is_harmless out && tail -n 1 out
}
attack "escape sequences in the daemon's configuration" "escaped in its messages" evil_daemon

evil_report() {
  inputs_model >model.yaml
  { inputs_log 2 | sed "1a # robot: $inputs_evil"; } >log.csv
  wheelwright report log.csv --model model.yaml -o report.html >out 2>&1 || { cat out; return 1; }
  inputs_is_harmless report.html && echo "a page of $(wc -c <report.html) bytes"
}
attack "escape sequences in a log, in a report" "escaped in the page" evil_report
