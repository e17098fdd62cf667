# The entry points of this repository. `make help` lists them.

.DEFAULT_GOAL := help
.NOTPARALLEL:
SHELL := /bin/sh

# Tools that the recipes install for this repository alone.
TOOLS := $(CURDIR)/target/tools
export PATH := $(TOOLS)/bin:$(PATH)
CARGO_DENY_VERSION := 0.20.2
CARGO_FUZZ_VERSION := 0.13.2

WIREBEND := target/release/wirebend
RUN := target/run
PEERS := target/peers
# The files of firmware/machines.
MACHINES := wirebend-kit howtomechatronics
# How long `make fuzz` stays with one target.
FUZZ_SECONDS ?= 120

.PHONY: help
help: ## list the targets
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-14s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

# The program and the drivers that ship with it: it finds them in the folder that it is in itself.
DRIVERS := wirebend-kit pensa tables grbl howtomechatronics
.PHONY: build
build: check-tools ## the program and its drivers, in target/release
	cargo build --release --package wirebend-cli $(DRIVERS:%=--package wirebend-driver-%)

# The bunny has two bends and two edges that the 293 dollar bender cannot make: status 4 says so, the report
# says where, and what is written is written all the same.
NOT_FEASIBLE = || test $$? -eq 4
BUNNY := examples/bunny.obj --face-edges --double
HOUSE := examples/house.obj

.PHONY: run
run: build ## plan the bunny, compare machines, bend the house on the simulated machine; files go to target/run
	@mkdir -p $(RUN)
	@echo; echo "--- the drivers"
	$(WIREBEND) drivers
	@echo; echo "--- the bunny on the 293 dollar bender"
	$(WIREBEND) plan $(BUNNY) --machine wirebend-kit --despite-errors -o $(RUN)/bunny-wirebend-kit.wbjob --force $(NOT_FEASIBLE)
	$(WIREBEND) export $(RUN)/bunny-wirebend-kit.wbjob -o $(RUN)/bunny-wirebend-kit.txt --force
	@echo; echo "--- what changes on a Pensa D.I.Wire Pro"
	$(WIREBEND) plan $(BUNNY) --machine wirebend-kit --compare pensa-diwire-pro $(NOT_FEASIBLE)
	$(WIREBEND) plan $(BUNNY) --machine pensa-diwire-pro -o $(RUN)/bunny-pensa.wbjob --force
	$(WIREBEND) export $(RUN)/bunny-pensa.wbjob -o $(RUN)/bunny-pensa.dsw --force
	@echo; echo "--- the house for other machines: G-code, the clone's commands, a table"
	$(WIREBEND) export $(HOUSE) --machine grbl-bender -o $(RUN)/house.nc --force
	$(WIREBEND) export $(HOUSE) --machine howtomechatronics -o $(RUN)/house-howtomechatronics.txt --force
	$(WIREBEND) export $(HOUSE) --machine table-bender -o $(RUN)/house.csv --force
	@echo; echo "--- pictures, and the wire as a Pensa with typical errors makes it"
	$(WIREBEND) export $(BUNNY) --machine wirebend-kit --format svg -o $(RUN)/bunny.svg --force
	$(WIREBEND) simulate $(RUN)/bunny-pensa.wbjob --noise bend-forming --svg $(RUN)/bunny-made.svg --force
	@echo; echo "--- the house, made by the simulated machine"
	$(WIREBEND) plan $(HOUSE) --machine wirebend-kit -o $(RUN)/house.wbjob --force
	$(WIREBEND) run $(RUN)/house.wbjob --port sim:max --yes --record $(RUN)/house.record.json --force --runs-folder $(RUN)/runs
	$(WIREBEND) simulate $(RUN)/house.wbjob --svg $(RUN)/house-made.svg --force
	@echo; ls -l $(RUN)

.PHONY: firmware
firmware: firmware-tools ## the controllers' programs for every machine, in target/firmware
	@for machine in $(MACHINES); do \
		$(MAKE) --no-print-directory -C firmware MACHINE=$$machine OUT=$(CURDIR)/target/firmware/$$machine || exit 1; \
	done

.PHONY: firmware-soak
firmware-soak: check-tools firmware-tools ## the whole bunny on the core and on the board's binary, pulse by pulse: minutes
	cargo bench --package wirebend-tests-firmware --bench bunny

.PHONY: test
test: check-tools firmware-tools fmt-check lint unit doc tidy generate-check fuzz-check deny ## every check: format, lints, tests, documentation, tidiness, licences

.PHONY: bench
bench: check-tools check-python ## figures of this machine, ours and the peer's in the same run
	cargo build --release --package wirebend-cli --package wirebend-benches
	test -x $(PEERS)/bin/python || python3 -m venv $(PEERS)
	$(PEERS)/bin/python -m pip install --quiet --disable-pip-version-check --requirement benches/peers/requirements.txt
	cargo bench --package wirebend-benches
	cargo run --quiet --release --package wirebend-benches --bin figures -- target/release/wirebend $(PEERS)/bin/python

.PHONY: fuzz
fuzz: check-tools check-clang ## search for inputs that break a reader or the firmware, two minutes a target (FUZZ_SECONDS=120)
	@echo "--- fuzz the firmware's core, $(FUZZ_SECONDS) s"
	$(MAKE) --no-print-directory -C firmware fuzz FUZZ_SECONDS=$(FUZZ_SECONDS)
	@cargo fuzz --version >/dev/null 2>&1 || cargo install cargo-fuzz --locked --version $(CARGO_FUZZ_VERSION) --root $(TOOLS)
	@targets=$$(RUSTC_BOOTSTRAP=1 cargo fuzz list) || exit 1; \
	for target in $$targets; do \
		echo "--- fuzz $$target, $(FUZZ_SECONDS) s"; \
		mkdir -p "fuzz/corpus/$$target"; \
		RUSTC_BOOTSTRAP=1 cargo fuzz run "$$target" "fuzz/corpus/$$target" "fuzz/seeds/$$target" -- \
			-max_total_time=$(FUZZ_SECONDS) -rss_limit_mb=2048 -max_len=65536 || exit 1; \
	done

# --- parts of the above, to run alone while working

.PHONY: fmt fmt-check
fmt: ## format the code
	cargo fmt --all
fmt-check:
	cargo fmt --all --check

.PHONY: lint
lint: ## clippy on everything
	cargo clippy --workspace --all-targets -- -D warnings

.PHONY: unit
unit:
	cargo test --workspace

.PHONY: doc
doc:
	RUSTDOCFLAGS="-D warnings" cargo doc --workspace --no-deps

.PHONY: tidy
tidy: ## the rules of the house that the compiler cannot check
	cargo xtask tidy

.PHONY: generate generate-check
generate: ## write the committed files that are made from code
	cargo xtask examples
	cargo xtask generate
generate-check:
	cargo xtask examples --check
	cargo xtask generate --check

# Fuzz targets are outside the workspace; compiled here so that they do not rot.
.PHONY: fuzz-check
fuzz-check:
	cargo check --manifest-path fuzz/Cargo.toml

# Fetching brings the crates of other systems too, whose licences are looked at although nothing here builds them.
.PHONY: deny
deny:
	@cargo deny --version >/dev/null 2>&1 || cargo install cargo-deny --locked --version $(CARGO_DENY_VERSION) --root $(TOOLS)
	cargo fetch --quiet --locked
	cargo deny --offline --log-level error check licenses bans sources
	@if ls -d "$${CARGO_HOME:-$$HOME/.cargo}"/advisory-dbs/*/ >/dev/null 2>&1; then \
		echo "cargo deny --offline --log-level error check advisories"; \
		cargo deny --offline --log-level error check advisories; \
	else \
		echo "advisories: not checked, no advisory database on this machine; to have one: cargo deny fetch db"; \
	fi

# Names everything that is missing at once, with the command that installs it.
.PHONY: check-tools
check-tools: ## are the tools here that everything else needs?
	@missing=0; \
	say() { echo "$$1; to install it: $$2" >&2; missing=1; }; \
	has() { command -v "$$1" >/dev/null 2>&1; }; \
	has git || say "git is missing" "apt-get install -y git"; \
	has make || say "make is missing" "apt-get install -y build-essential"; \
	{ has cc && has c++; } || say "a C and C++ compiler is missing" "apt-get install -y build-essential"; \
	needed=$$(sed -n 's/^rust-version = "\([0-9.]*\)".*/\1/p' Cargo.toml); \
	found=$$(rustc --version 2>/dev/null | sed 's/^rustc \([0-9.]*\).*/\1/'); \
	if ! has cargo || [ -z "$$found" ]; then \
		say "cargo and rustc (Rust $$needed or newer) are missing" "apt-get install -y rustup && rustup default stable"; \
	else \
		echo "$$found $$needed" | awk '{ split($$1, f, "."); split($$2, n, "."); exit !(f[1] > n[1] || (f[1] == n[1] && f[2] + 0 >= n[2] + 0)) }' \
			|| say "Rust $$found is too old, $$needed or newer is needed" "rustup update stable"; \
		cargo fmt --version >/dev/null 2>&1 || say "rustfmt is missing" "rustup component add rustfmt"; \
		cargo clippy --version >/dev/null 2>&1 || say "clippy is missing" "rustup component add clippy"; \
	fi; \
	exit $$missing

# The compiler for the controller and the simulator of its chip: installed where that can be done without asking.
FIRMWARE_PACKAGES := gcc-avr binutils-avr avr-libc libsimavr-dev libelf-dev pkg-config
INSTALL_FIRMWARE := apt-get install -y --no-install-recommends $(FIRMWARE_PACKAGES)
.PHONY: firmware-tools
firmware-tools:
	@here() { \
		command -v avr-gcc >/dev/null && command -v avr-objcopy >/dev/null && command -v pkg-config >/dev/null \
			&& test -f "$$(avr-gcc -mmcu=atmega328p -print-file-name=crtatmega328p.o 2>/dev/null)" \
			&& pkg-config --exists simavr; \
	}; \
	here && exit 0; \
	if command -v apt-get >/dev/null; then \
		if [ "$$(id -u)" = 0 ]; then $(INSTALL_FIRMWARE); \
		elif sudo -n true 2>/dev/null; then sudo -n $(INSTALL_FIRMWARE); fi; \
	fi; \
	here || { echo "the compiler or the simulator of the firmware is missing; to install them: $(INSTALL_FIRMWARE)" >&2; exit 1; }

.PHONY: check-clang
check-clang:
	@command -v clang >/dev/null 2>&1 || { echo "clang is missing; to install it: apt-get install -y clang" >&2; exit 1; }

# NetworkX of benches/peers/requirements.txt needs Python 3.11.
.PHONY: check-python
check-python:
	@missing=0; \
	say() { echo "$$1; to install it: $$2" >&2; missing=1; }; \
	if ! python3 -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; then \
		say "Python 3.11 or newer is missing" "apt-get install -y python3 python3-venv"; \
	elif ! python3 -c 'import venv, ensurepip' 2>/dev/null; then \
		say "Python's venv is missing" "apt-get install -y python3-venv"; \
	fi; \
	exit $$missing
