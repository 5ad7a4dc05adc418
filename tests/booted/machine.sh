# A minimal Debian that is booted by systemd-nspawn, with the package, a simulated robot and a device that can be
# unplugged. Sourced by tests/booted/run.
#
# The robot is roomba-sim on a pseudo-terminal, which udev does not know. So a rule gives the name /dev/roomba to a
# virtual console as well, and plugging is an event for that: what follows, from the device unit on, is the system's
# own. systemd listens to udev in a container only once it has been started anew (daemon-reexec).

caches=/var/cache/wheelwright-booted
console=/sys/class/tty/tty40

skip() { echo "SKIPPED: $*"; exit 77; }

can_boot() {
  [[ $EUID == 0 ]] || skip "the booted system needs root"
  local need
  for need in debootstrap systemd-nspawn nsenter dpkg-deb; do
    command -v "$need" >/dev/null || skip "the booted system needs $need (packages debootstrap, systemd-container)"
  done
  [[ -e $console ]] || skip "the booted system needs a virtual console as stand-in for an adapter"
}

# The package of a name that may be one which others provide.
real_package() {
  if [[ $(apt-cache show "$1" 2>/dev/null) ]]; then
    echo "$1"
  else
    apt-cache showpkg "$1" | awk 'found { print $1; exit } /^Reverse Provides/ { found = 1 }'
  fi
}

# make_base PACKAGE: the base system with what the package depends on, made once for each set of that.
make_base() {
  local release mirror needs
  release=$(. /etc/os-release && echo "$VERSION_CODENAME")
  needs=$(dpkg-deb -f "$1" Depends | tr ',' '\n' | sed -E 's/[(|].*//; s/ //g' | sort -u |
    while read -r name; do real_package "$name"; done | paste -sd ,)
  cache=$caches/$release-$(sha256sum <<<"$needs" | head -c 8)
  [[ -e $cache/.done ]] && return
  mirror=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources} 2>/dev/null | grep -v '^#' |
    grep -oE 'https?://[^ ]*debian[^ ]*' | grep -v security | head -n 1 || true)
  rm -rf "$caches"
  mkdir -p "$cache"
  debootstrap --variant=minbase --include="systemd,systemd-sysv,dbus,udev,$needs" "$release" "$cache" "$mirror" \
    >"$cache.log" 2>&1 || skip "debootstrap failed: $(tail -n 1 "$cache.log")"
  touch "$cache/.done"
}

# Without booting it: a command in the machine's tree.
offline() { systemd-nspawn -q -D "$root" --register=no --keep-unit --private-network --as-pid2 "$@" </dev/null 2> >(grep -v "Attempted to remove" >&2); }

prepare() {
  cp -a --reflink=auto "$cache/." "$root/"
  cat >"$root/etc/udev/rules.d/99-stand-in.rules" <<RULE
SUBSYSTEM=="tty", KERNEL=="$(basename "$console")", TAG+="systemd", ENV{SYSTEMD_ALIAS}="/dev/roomba"
RULE
  cat >"$root/etc/systemd/system/robot.service" <<'UNIT'
[Service]
ExecStart=/usr/bin/roomba-sim --link /dev/roomba --truth /run/truth.csv
ExecStartPost=/bin/sh -c 'until [ -e /dev/roomba ]; do sleep 0.05; done; chgrp dialout $(readlink /dev/roomba); chmod 660 $(readlink /dev/roomba)'
[Install]
WantedBy=multi-user.target
UNIT
  cat >"$root/etc/systemd/system/listen-to-udev.service" <<'UNIT'
[Unit]
After=robot.service
[Service]
Type=oneshot
ExecStart=/bin/systemctl --no-block daemon-reexec
[Install]
WantedBy=multi-user.target
UNIT
  mkdir -p "$root/etc/systemd/system/wheelwrightd.service.d"
  printf '[Service]\nDeviceAllow=char-pts rw\n' >"$root/etc/systemd/system/wheelwrightd.service.d/pseudo-terminal.conf"
  offline systemctl -q enable robot listen-to-udev
}

boot() {
  SYSTEMD_NSPAWN_API_VFS_WRITABLE=yes systemd-nspawn -q -D "$root" --register=no --keep-unit --private-network --boot \
    --machine="wheelwright-test-$$" </dev/null >"$work/console" 2>&1 &
  nspawn=$!
  wait_for 60 booted || skip "this system does not boot a container: $(tail -n 1 "$work/console")"
}

# A machine that reboots ends systemd-nspawn with this status, and is to be started again.
wait_for_reboot() {
  local status=0
  wait "$nspawn" || status=$?
  nspawn=
  ((status == 133)) && boot
}

# Ends every process of the machine at once, without a word to any of them.
cut_power() {
  kill -KILL "$leader"
  wait "$nspawn" 2>/dev/null || true
  nspawn=
}

find_leader() {
  local outer
  leader=
  leader=$(pgrep -P "$nspawn" -x systemd | head -n 1)
  [[ $leader ]] && return
  for outer in $(pgrep -P "$nspawn"); do leader=$(pgrep -P "$outer" -x systemd | head -n 1); done
  [[ $leader ]]
}
inside() { nsenter -t "$leader" -m -u -i -n -p -C -- "$@"; }
booted() { find_leader && [[ $(inside systemctl is-system-running 2>/dev/null) =~ running|degraded ]]; }

# wait_for SECONDS COMMAND...: until it succeeds.
wait_for() {
  local until=$((SECONDS + $1))
  shift
  until "$@"; do
    ((SECONDS < until)) || return 1
    sleep 0.1
  done
}

plug() { inside udevadm trigger --settle -c add "$console"; }
unplug() { inside udevadm trigger --settle -c remove "$console"; }

state() { inside systemctl show -P "$1" wheelwrightd; }
active() { [[ $(state ActiveState) == active ]]; }
said() { inside journalctl -q -u wheelwrightd --since "@$since" --no-pager -o cat | grep -qF -- "$1"; }
now() { date +%s.%N; }
main_pid() { state MainPID; }

# What the robot truly did since `since` (seconds of the epoch): milliseconds until both wheels stood for good; the
# robot is started anew to get its log. Fails where the wheels never moved.
ms_to_rest() {
  inside systemctl stop robot
  inside awk -F, -v since="$1" '
    /^# started_unix_ms/ { split($0, part, ": "); started = part[2] / 1000 }
    /^[0-9]/ { moving = $5 ^ 2 + $6 ^ 2 > 1e-6; at = started + $1
      if (moving) { any = 1; if (at > since) last = at } }
    END { if (!any) exit 1; printf "%.0f\n", last ? 1000 * (last - since) : 0 }' /run/truth.csv
  inside systemctl start robot
}
