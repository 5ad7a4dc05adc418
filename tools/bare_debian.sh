# A bare Debian of any release in a folder, whose commands systemd-nspawn runs. Sourced by tools/package and .ci/trixie.

bare_cache=/var/cache/wheelwright

# What keeps this machine from having one; nothing where all is there.
bare_debian_lacks() {
  [[ $EUID -eq 0 ]] || { echo "root"; return; }
  local need
  for need in debootstrap systemd-nspawn; do
    command -v "$need" >/dev/null || { echo "$need (tools/install-dependencies boot)"; return; }
  done
}

debian_mirror() {
  cat /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources} 2>/dev/null | grep -v '^#' |
    grep -oE 'https?://[^ ]*debian[^ ]*' | grep -v security | head -n 1 || true
}

# bare_debian RELEASE ROOT: makes ROOT a bare system, a copy of one that stays in the cache, and gives it what this machine
# needs to reach the mirror.
bare_debian() {
  local base=$bare_cache/$1
  mkdir -p "$bare_cache" "$2"
  if [[ ! -e $base.done ]]; then
    rm -rf "$base"
    debootstrap --variant=minbase --include=ca-certificates "$1" "$base" "$(debian_mirror)" >"$base.log" 2>&1 ||
      { echo "debootstrap $1 failed: $(tail -n 1 "$base.log")" >&2; return 1; }
    touch "$base.done"
  fi
  cp -a --reflink=auto "$base/." "$2/"
  cp -aL /etc/ssl/certs/ca-certificates.crt "$2/etc/ssl/certs/"
  cp -a /etc/apt/apt.conf.d /etc/apt/auth.conf.d "$2/etc/apt/"
}

# inside ROOT COMMAND...: in /project, if there is one.
inside() {
  local root=$1 name
  shift
  local settings=(--setenv=DEBIAN_FRONTEND=noninteractive --setenv=HOME=/root)
  for name in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY; do
    [[ -z ${!name:-} ]] || settings+=("--setenv=$name=${!name}")
  done
  mkdir -p "$root/project"
  systemd-nspawn -q -D "$root" --register=no --keep-unit --resolv-conf=copy-host --console=pipe --as-pid2 --chdir=/project \
    "${settings[@]}" "$@" </dev/null 2> >(grep -v 'Attempted to remove' >&2)
}

# build_system NAME RELEASE: brings a bare system that stays, with what is installed and compiled in it, to build in, and the
# sources of this working tree into its /project. One run at a time; sets `root`.
build_system() {
  root=$bare_cache/build-$1
  mkdir -p "$bare_cache"
  exec {build_system_lock}>"$root.lock"
  flock -n "$build_system_lock" || { echo "waiting for another run in $root to end" >&2; flock "$build_system_lock"; }
  if [[ ! -e $root.done ]]; then
    rm -rf "$root"
    bare_debian "$2" "$root" || return 1
    touch "$root.done"
  fi
  mkdir -p "$root/project"
  find "$root/project" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
  # Each source is new to ninja, and the compiler's cache knows it.
  git ls-files -z | tar --null --files-from=- --create | tar -x -m -C "$root/project"
}
