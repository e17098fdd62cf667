#!/bin/sh
# Runs a command with what nothing else wants of the processor.
set -eu
# The scheduler of Linux divides it among sessions first, and asks then how nice the processes of each are.
if command -v setsid >/dev/null && [ -w /proc/self/autogroup ]; then
	setsid sh -c 'echo 19 >/proc/self/autogroup; exec nice -n 19 "$@"' spare "$@" &
else
	nice -n 19 "$@" &
fi
command=$!
# An interrupt comes to whoever waits for this, and ends it.
trap 'kill -- -$command 2>/dev/null || kill $command; exit 130' TERM HUP
wait $command
