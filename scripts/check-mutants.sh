#!/bin/sh
# Breaks the protocol between the programs, one rule at a time, in a copy of the sources, and looks whether the tests
# notice. A mutant that survives is an error: a rule that no test guards.
#   scripts/check-mutants.sh [name...]     without names: all
set -eu
cd "$(dirname "$0")/.."
work=$(mktemp -d "${TMPDIR:-/tmp}/rtsuite-mutants-XXXXXX")
chmod 755 "$work"
export RT_TEST_INSTANCE="m$$-" TMPDIR="$work/tmp"
mkdir "$TMPDIR"
chmod 755 "$TMPDIR"
trap 'rm -rf "$work" /dev/shm/rts.*.m$$-*' EXIT
trap 'exit 130' INT TERM
git ls-files -co --exclude-standard | tar -cf - -T - | tar -xf - -C "$work"
cd "$work"
cp -R libs/ipc intact
cmake --preset headless >/dev/null

# name file sed-expression
mutants() {
    cat <<'END'
recheck-removed channel/frame_ring.cpp /memory_order_relaxed) != whole(number)/d
odd-mark-omitted channel/frame_ring.cpp /sequence.store(writing(next_)/d
latest-before-copy channel/frame_ring.cpp s/^    fenceBeforeWriting();/&segment_->latest.store(next_);/
status-recheck-removed channel/sequenced_value.h /memory_order_relaxed) != before/d
magic-first endpoint/publication.cpp s/^ *header.handshake = .*/header.magic.store(kControlMagic);&/
link-epoch-unchecked endpoint/link.cpp s/facts->epoch != facts_.epoch/false/
message-epoch-unchecked channel/message.cpp s/header.epoch != epoch/false/
handshake-unchecked endpoint/link.cpp s/facts->handshake != ownHandshake()/false/
wait-to-send channel/command_queue.cpp s/state_->queue.try_send(\(.*\), 0)/(state_->queue.send(\1, 0), true)/
wait-to-receive channel/command_queue.cpp s/if (!state_->queue.try_receive(\(.*\)))/state_->queue.receive(\1); if (false)/
silence-is-death endpoint/link.cpp s/? LinkState::Busy :/? LinkState::Gone :/
lock-unchecked endpoint/link.cpp s/!segment_.locked(kServerLock) || replaced()/replaced()/
dead-clients-kept endpoint/server.cpp /ServedClient::declareDead(/d
queue-name-kept channel/command_queue.cpp s/~NameRemover() { Segment::remove(name); }//
nothing-removed-at-start endpoint/server.cpp /^        removeSegments(names);/d
names-not-watched endpoint/server.cpp /named()) publishAnew();/d
mode-unchecked platform/segment.cpp /if (!facts.ours)/d
space-not-reserved platform/segment.cpp s/reserveSpace(\(.*\), bytes, name);/if (ftruncate(\1, static_cast<off_t>(bytes)) != 0) throw 1;/;s/^#include "ipc.platform.system.h"/&\n#include <unistd.h>/
crc-unchecked channel/message.cpp /header.checksum) return false/d
wall-clock-waits platform/system.h s/std::chrono::steady_clock/std::chrono::system_clock/
wall-clock-in-the-queue platform/boost_interprocess.h /define pthread_mutex_timedlock/d
pipes-waited-for platform/system_posix.cpp s/O_NONBLOCK | //
queue-unchecked channel/command_queue.cpp s/!isSoundQueue([^)]*)/false/
fields-not-repaired endpoint/server.cpp /^        repair();/d
taken-for-dead-unnoticed endpoint/attachment.cpp s/slot_->clientTag.load(std::memory_order_relaxed) == tag_/true/
keys-kept endpoint/attachment.cpp s/^    keys.restore(.*/(void)keys;/
END
}

build() { cmake --build --preset headless --target test_ipc test_ipc_process -- -j "${RT_JOBS:-$(nproc)}" >build.log 2>&1; }

# Prints the test that fails, or that hangs, first; nothing when all pass.
caught() {
    for program in test_ipc "test_ipc_process --gtest_filter=-Killed.ServersAndClients"; do
        code=0
        # shellcheck disable=SC2086
        timeout -k 5 90 build/headless/bin/$program --gtest_fail_fast >run.log 2>&1 || code=$?
        [ $code -eq 0 ] && continue
        failed=$(sed -n 's/^\[  FAILED  \] \([^ ,]*\).*/\1/p' run.log | head -n 1)
        [ -n "$failed" ] || failed="$(sed -n 's/^\[ RUN *\] //p' run.log | tail -n 1) (ended with $code)"
        echo "$failed"
        return
    done
}

echo "check-mutants: building"
build || { tail -n 20 build.log; exit 1; }
survivor=$(caught)
if [ -n "$survivor" ]; then
    echo "check-mutants: $survivor fails without any mutant" >&2
    exit 1
fi
survived=0
mutants >mutants.txt
while read -r name file expression; do
    case " $* " in "  " | *" $name "*) ;; *) continue ;; esac
    sed -i "$expression" "libs/ipc/$file"
    if cmp -s "libs/ipc/$file" "intact/$file"; then
        echo "check-mutants: $name changes nothing: bring its line in this script up to date" >&2
        survived=$((survived + 1))
        continue
    fi
    if ! build; then
        echo "check-mutants: $name does not compile: bring its line in this script up to date" >&2
        grep -m 3 error build.log >&2 || true
        survived=$((survived + 1))
    else
        test=$(caught)
        echo "$name: ${test:-SURVIVED}"
        [ -n "$test" ] || survived=$((survived + 1))
    fi
    cp "intact/$file" "libs/ipc/$file"
done <mutants.txt
[ $survived -eq 0 ] || exit 1
echo "check-mutants: every mutant is caught"
