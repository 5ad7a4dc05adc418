# link: a serial line that is believed too easily.

# A robot at ./robot, and what stands between it and the host at ./line. relay BODY: Python that sees each piece from
# the robot as `data` (bytearray), with `now` in seconds and `state` (dict) of its own, and leaves in `data` what arrives.
start_robot() {
  roomba-sim --link "$PWD/robot" "$@" > robot.txt 2>&1 &
  wait_for '[[ -e robot ]]'
}

relay() {
  command -v python3 > /dev/null || return 77
  cat > relay.py <<PYTHON
import os, pty, random, select, time, tty
random.seed(1)
robot = os.open("robot", os.O_RDWR | os.O_NOCTTY)
tty.setraw(robot)
ours, theirs = pty.openpty()
tty.setraw(theirs)
os.symlink(os.ttyname(theirs), "line.part")
os.rename("line.part", "line")
state = {}
start = time.monotonic()
while True:
    ready = select.select([robot, ours], [], [], 0.01)[0]
    if ours in ready:
        os.write(robot, os.read(ours, 4096))
    data = bytearray(os.read(robot, 4096)) if robot in ready else bytearray()
    now = time.monotonic() - start
$(sed 's/^/    /' <<<"$1")
    if data:
        os.write(ours, data)
PYTHON
  python3 relay.py 2> relay.txt &
  wait_for '[[ -e line ]]'
}

wait_for() {
  local i
  for ((i = 0; i < 100; ++i)); do
    eval "$1" && return 0
    sleep 0.05
  done
  return 1
}

# examine DEVICE STATUS TEXT...: the doctor ends so, and says each text.
examine() {
  local device=$1 wanted=$2 status=0 text
  shift 2
  wheelwright doctor --device "$device" > doctor.txt 2>&1 || status=$?
  for text in "$@"; do
    grep -qF -e "$text" doctor.txt || { echo "exit $status, without '$text': $(tail -n 1 doctor.txt)"; return 1; }
  done
  grep -F -e "$1" doctor.txt | head -n 1 | tr -s ' '
  [[ $status == "$wanted" ]]
}

lost_bit_7() {
  start_robot && relay 'data = bytearray(b & 0x7f for b in data)' || return
  examine line 1 'bit 7 never set' 'use another adapter' 'Not fit to drive'
}

lost_bit_6() {
  start_robot && relay 'data = bytearray(b & 0xbf for b in data)' || return
  examine line 1 'bit 6 never set' 'Not fit to drive'
}

stuck_bit_0() {
  start_robot && relay 'data = bytearray(b | 0x01 for b in data)' || return
  examine line 1 'Not fit to drive'
}

corrupt_stream() {
  start_robot && relay '
for i in range(len(data)):
    if random.random() < 0.0028: data[i] ^= 0x55' || return
  examine line 1 'checksum rule: bytes are lost or damaged' 'Not fit to drive'
}

boots_again() {
  start_robot && relay '
if now - state.get("last", 0) > 1.5:
    state["last"] = now
    data += b"bl-start\r\nSTR730\r\nbootloader id: #x4718535C FFFFFFFF\r\n"' || return
  examine line 1 'booted' 'battery' 'board' 'Not fit to drive'
}

prints_for_ever() {
  start_robot && relay '
if now - state.get("last", 0) > 0.7:
    state["last"] = now
    data += b"error: i2c timeout\r\n"' || return
  examine line 1 'prints without end' 'battery' 'board' 'Not fit to drive'
}

sound_robot() {
  start_robot || return
  examine robot 0 'all eight bits pass' 'Fit to drive'
}

attack "a sound robot" "is fit to drive" sound_robot
attack "the top bit lost in every byte" "the doctor blames the adapter" lost_bit_7
attack "bit 6 lost in every byte" "the doctor blames the adapter" lost_bit_6
attack "bit 0 set in every byte" "not fit to drive" stuck_bit_0
attack "15 % corrupt stream frames" "not fit to drive" corrupt_stream
attack "a robot that boots again and again" "not fit to drive, battery and board named" boots_again
attack "a robot that prints errors for ever" "not fit to drive, battery and board named" prints_for_ever
