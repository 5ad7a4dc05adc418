# No output replaces what it did not make, and nothing that was asked for is lost or invented.

example_log() {
  {
    printf '# wheelwright_drive_log: 1\n# robot: example\n# wheel_base_m: %s\n# period_s: %s\n' "${1:-0.235}" "${2:-0.018}"
    printf '# metres_per_tick_left: 0.000444\n# metres_per_tick_right: 0.000444\nt,cmd_left,cmd_right,ticks_left,ticks_right\n'
    awk 'BEGIN { for (k = 0; k < 300; ++k) printf "%.3f,0.1,0.1,%d,%d\n", k * 0.018, k * 4, k * 4 }'
  } >log.csv
  cp "$source_folder/tests/booted/model.yaml" model.yaml
}

daemon_yaml() {
  printf 'robot: {name: %s}\nlink: {device: /dev/null}\ncalibration: {when: %s, model_file: %s}\nrun: {log_folder: runs}\n' \
    "${3:-roomba}" "$1" "$2" >daemon.yaml
}

# refused EXPECTED COMMAND...: it ends with a status that is not 0, in 10 s, and says EXPECTED.
refused() {
  local expected=$1 status=0
  shift
  timeout 10 "$@" >out 2>err || status=$?
  echo "exit $status: $(tail -n 1 err)"
  [[ $status != 0 && $status != 124 ]] && grep -q -- "$expected" err
}

status_keeps_text() {
  daemon_yaml never model.yaml
  echo precious >notes.txt
  refused "holds something else" wheelwrightd --config daemon.yaml --status notes.txt && [[ $(cat notes.txt) == precious ]]
}
status_keeps_configuration() {
  daemon_yaml never model.yaml
  cp daemon.yaml before
  refused "would replace an input" wheelwrightd --config daemon.yaml --status daemon.yaml && cmp -s before daemon.yaml
}
status_keeps_folder() {
  daemon_yaml never model.yaml
  mkdir empty
  refused "is a folder" wheelwrightd --config daemon.yaml --status empty && [[ -d empty ]]
}
lateness_keeps_device() {
  daemon_yaml never model.yaml
  refused "is a device" wheelwrightd --config daemon.yaml --lateness /dev/null && [[ -c /dev/null ]]
}
model_file_is_checked_at_start() {
  daemon_yaml always no_such_folder/model.yaml
  refused "no_such_folder" wheelwrightd --config daemon.yaml --check
}
report_follows_no_link() {
  example_log
  echo precious >notes.txt
  ln -s notes.txt page.html.part
  wheelwright report log.csv -o page.html >out 2>err
  echo "$(tail -n 1 out err | tr '\n' ' ')"
  [[ $(cat notes.txt) == precious && -L page.html.part ]]
}
report_waits_for_no_pipe() {
  example_log
  mkfifo page.html
  refused "is a pipe" wheelwright report log.csv -o page.html
}
simulate_keeps_part() {
  example_log
  cp log.csv r.csv.part
  cp log.csv before
  wheelwright simulate model.yaml r.csv.part -o r.csv >out 2>err
  echo "$(tail -n 1 err out | tr '\n' ' ')"
  cmp -s before r.csv.part
}
simulate_keeps_hard_link() {
  example_log
  ln log.csv other.csv
  refused "would replace an input" wheelwright simulate model.yaml log.csv -o other.csv
}
gap_keeps_run() {
  example_log
  mkdir run
  cp log.csv run/drive_log.csv
  cp model.yaml run/
  refused "folder of a run" wheelwright gap --train log.csv -o run && cmp -s model.yaml run/model.yaml
}
gap_keeps_model_beside_inputs() {
  example_log
  cp model.yaml before
  refused "model.yaml" wheelwright gap --train log.csv -o . && cmp -s model.yaml before
}
truth_keeps_replay() {
  example_log
  cp log.csv before
  refused "would replace an input" roomba-sim --replay log.csv --truth log.csv && cmp -s log.csv before
}
export_takes_two_names() {
  example_log
  refused "two outputs" wheelwright export log.csv --csv same --mcap same && [[ ! -e same ]]
}
name_with_line_break() {
  daemon_yaml never model.yaml '"two\nlines"'
  refused "line break" wheelwrightd --config daemon.yaml --check
}
period_off() {
  example_log 0.235 10
  refused "period_s" wheelwright simulate model.yaml log.csv -o out.csv
}
wheel_base_of_nothing() {
  example_log 1e-300
  refused "log.csv:3: 'wheel_base_m'" wheelwright fit log.csv -o fitted.yaml
}
second_document() {
  example_log
  printf -- '---\nrobot: other\n' >>model.yaml
  refused "second document" wheelwright simulate model.yaml log.csv -o out.csv
}
gain_of_a_million() {
  example_log
  sed -i '0,/0.1, 0.2/s//1e6, 0.2/' model.yaml
  refused "from_left" wheelwright simulate model.yaml log.csv -o out.csv
}

attack "--status NOTES" "refused, the text stays" status_keeps_text
attack "--status CONFIGURATION" "refused, the file stays" status_keeps_configuration
attack "--status FOLDER" "refused, the folder stays" status_keeps_folder
attack "--lateness DEVICE" "refused, the device stays" lateness_keeps_device
attack "model_file in no folder" "found at the start" model_file_is_checked_at_start
attack "page.html.part is a link" "not followed" report_follows_no_link
attack "the page is a pipe" "refused at once" report_waits_for_no_pipe
attack "an input called OUTPUT.part" "stays" simulate_keeps_part
attack "the output is a hard link of an input" "refused" simulate_keeps_hard_link
attack "gap -o into a run's folder" "refused, the model stays" gap_keeps_run
attack "gap -o beside a model" "refused, the model stays" gap_keeps_model_beside_inputs
attack "roomba-sim --replay X --truth X" "refused, X stays" truth_keeps_replay
attack "export --csv X --mcap X" "refused" export_takes_two_names
attack "a robot's name with a line break" "refused" name_with_line_break
attack "period_s 10 over rows 18 ms apart" "refused" period_off
attack "a wheel base of 1e-300" "refused at its line" wheel_base_of_nothing
attack "a second YAML document" "refused" second_document
attack "a gain of 1e6" "refused" gain_of_a_million
