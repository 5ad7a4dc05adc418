# Sourced by tests that read or drive what the project makes with programs of others.
#   bring_packages SUBJECT SOURCE_FOLDER WORK_FOLDER
# puts the test files of SOURCE_FOLDER and the packages that its package-lock.json names into WORK_FOLDER, which stays
# beside the build. Ends the test with 77, a skip, and the reason where node, npm or the packages are not to be had.
bring_packages() {
  local subject=$1 source=$2 work=$3
  command -v node >/dev/null || skip "$subject" "no node (tools/install-dependencies browser)"
  [[ $(node -p 'process.versions.node.split(".")[0]') -ge 18 ]] || skip "$subject" "node is older than 18"
  mkdir -p "$work"
  if ! cmp -s "$source/package-lock.json" "$work/package-lock.json" || [[ ! -d $work/node_modules ]]; then
    command -v npm >/dev/null || skip "$subject" "no npm (tools/install-dependencies browser)"
    cp "$source/package.json" "$source/package-lock.json" "$work/"
    (cd "$work" && timeout 120 npm ci --ignore-scripts --no-audit --no-fund) >"$work/npm.log" 2>&1 ||
      { rm -f "$work/package-lock.json"; skip "$subject" "npm cannot get its packages ($work/npm.log)"; }
  fi
  cp "$source"/*.mjs "$work/"
}

skip() {
  echo "SKIPPED: $1: $2"
  exit 77
}
