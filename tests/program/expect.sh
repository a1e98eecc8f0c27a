# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# What the tests of the program share; to be sourced by bash with the program as
# first argument. They run in an empty folder that is removed at the end; what
# the program prints goes to another one.
# shellcheck shell=bash

set -uo pipefail

setae=$(realpath "$1")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
captured=$(mktemp -d)
trap 'rm -rf "$work" "$captured"' EXIT
cd "$work" || exit 1

# Two programs that start at the same time may both want to create the folder
# that Open MPI keeps for all sessions of a user, of which one fails.
export OMPI_MCA_orte_tmpdir_base=$captured

n_checks=0
n_failures=0

# check WHAT COMMAND...: count a failure unless COMMAND succeeds.
check() {
  local what=$1
  shift
  ((++n_checks))
  "$@" && return
  ((++n_failures))
  printf 'FAILED: %s\n' "$what"
  [[ -n ${call:-} ]] && printf '  of: %s\n' "$call"
  sed 's/^/  stderr: /' "$captured/err"
}

# run ARGUMENT...: call the program; leaves $status. One rank needs no network,
# and Open MPI starts twice as fast without.
run() {
  call="setae $*"
  OMPI_MCA_pml=ob1 OMPI_MCA_btl=self timeout 60 "$setae" "$@" >"$captured/out" 2>"$captured/err" </dev/null
  status=$?
}

# run_on RANKS ARGUMENT...: the same with mpirun, whose own notices are left out.
run_on() {
  local ranks=$1
  shift
  call="mpirun -np $ranks setae $*"
  : >"$captured/err"
  # shellcheck disable=SC2016
  timeout 240 mpirun --oversubscribe -np "$ranks" \
    bash -c 'exec "$@" 2>>"$0"' "$captured/err" "$setae" "$@" \
    >"$captured/out" 2>/dev/null </dev/null
  status=$?
}

# Every file with its size and time.
listing() { find . -mindepth 1 -printf '%p %s %T@\n' | sort; }

n_lines_on_stderr() { wc -l <"$captured/err"; }
on_stderr() { grep -qF -e "$1" "$captured/err"; }
on_stdout() { grep -qE -e "$1" "$captured/out"; }

# one_line_with FRAGMENT...: the program has failed with a single line that
# contains all of them.
one_line_with() {
  check "the exit status is $status, not 1" [ "$status" -eq 1 ]
  check "not one line on stderr" [ "$(n_lines_on_stderr)" -eq 1 ]
  check "the line does not begin with 'setae: '" \
    grep -q '^setae: ' "$captured/err"
  local fragment
  for fragment; do
    check "the line does not contain '$fragment'" on_stderr "$fragment"
  done
}

finish() {
  printf '%d checks, %d failures\n' "$n_checks" "$n_failures"
  ((n_checks > 0 && n_failures == 0))
  exit
}
