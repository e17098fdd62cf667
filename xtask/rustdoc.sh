#!/bin/sh
# In place of rustdoc under `cargo test --doc`, which names it everything that is built: runs the examples of a crate, then makes its
# pages, whose warnings are errors. `cargo doc` compiles all that others wrote once more, for pages alone.
set -eu
rustdoc "$@"
# The same words without those of tests.
set -- "$@" end-of-words
while [ "$1" != end-of-words ]; do
	case $1 in
	--test | --no-run) ;;
	--test-run-directory | --test-args | --test-runtool) shift ;;
	*) set -- "$@" "$1" ;;
	esac
	shift
done
shift
exec rustdoc "$@" --deny warnings --out-dir "$PAGES"
