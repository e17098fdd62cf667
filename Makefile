# The entry points of this repository. `make help` lists them.

.DEFAULT_GOAL := help
.NOTPARALLEL:
SHELL := /bin/sh

# Tools of cargo that the recipes install, compiled once for all clones of this user.
CARGO_DENY_VERSION := 0.20.2
CARGO_NEXTEST_VERSION := 0.9.143
CARGO_FUZZ_VERSION := 0.13.2
TOOLS := $(or $(XDG_CACHE_HOME),$(HOME)/.cache)/wirebend-kit/tools/deny-$(CARGO_DENY_VERSION)-nextest-$(CARGO_NEXTEST_VERSION)-fuzz-$(CARGO_FUZZ_VERSION)
export PATH := $(TOOLS)/bin:$(PATH)
CHECK_JSONSCHEMA_VERSION := 0.39.0
ZIZMOR_VERSION := 1.32.0
NODE := 20.19

WIREBEND := target/release/wirebend
XTASK := cargo xtask
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
# says where, and the files are written anyway.
NOT_FEASIBLE = || test $$? -eq 4
BUNNY := examples/bunny.obj --face-edges --double
HOUSE := examples/house.obj

# With a display the window opens on the house; without one the same is done by commands.
.PHONY: run
run: check-tools ## open the window on a sample with the simulated machine; without a display the same by commands, files in target/run
	@if [ -n "$$DISPLAY$$WAYLAND_DISPLAY" ] || [ "$$(uname)" != Linux ]; then \
		$(MAKE) --no-print-directory run-window; \
	else \
		echo "there is no display: the sample is planned, checked and bent by commands"; \
		$(MAKE) --no-print-directory run-commands; \
	fi

.PHONY: run-window
run-window: window ## open the window on the house
	@mkdir -p $(RUN)
	@# As a design: of a model a person is asked first what its numbers measure.
	$(WIREBEND) import $(HOUSE) --units mm -o $(RUN)/house.wirebend --force
	target/release/wirebend-kit $(RUN)/house.wirebend

.PHONY: run-commands
run-commands: build ## plan the bunny, compare machines, bend the house on the simulated machine; files go to target/run
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
	@echo; echo "--- the house, bent by the simulated machine"
	$(WIREBEND) plan $(HOUSE) --machine wirebend-kit -o $(RUN)/house.wbjob --force
	$(WIREBEND) run $(RUN)/house.wbjob --port sim:max --yes --record $(RUN)/house.record.json --force --runs-folder $(RUN)/runs
	$(WIREBEND) simulate $(RUN)/house.wbjob --svg $(RUN)/house-made.svg --force
	@echo; ls -l $(RUN)

# Vite serves the editor and reloads it at each change of ui/src; a change of Rust restarts the window.
.PHONY: dev
dev: check-tools window-tools ui/node_modules/.package-lock.json ## the window with hot reload; without a display the same in a browser
	@# In the browser as `make check` has built it: with fewer packages their dependencies would be compiled anew, for other features.
	@if [ -n "$$DISPLAY$$WAYLAND_DISPLAY" ] || [ "$$(uname)" != Linux ]; then \
		cargo build $(DRIVERS:%=--package wirebend-driver-%) && cd src-tauri && ../ui/node_modules/.bin/tauri dev; \
	else \
		cargo build --lib --bins && $(NPM) run --silent dev:browser -- $(CURDIR)/target/debug/wirebend-loopback $(CURDIR)/target/dev; \
	fi

.PHONY: firmware
firmware: firmware-tools ## the controllers' programs for every machine, in target/firmware
	@for machine in $(MACHINES); do \
		$(MAKE) --no-print-directory -C firmware MACHINE=$$machine OUT=$(CURDIR)/target/firmware/$$machine || exit 1; \
	done

.PHONY: firmware-soak
firmware-soak: check-tools firmware-tools ## the whole bunny on the core and on the board's binary, pulse by pulse: minutes
	cargo bench --package wirebend-tests-firmware --bench bunny

# The editor, built into the window: everything that compiles the window needs it.
NPM := npm --prefix ui
UI_SOURCES := $(shell find ui/src ui/index.html ui/vite.config.ts ui/package.json -type f 2>/dev/null)
ui/node_modules/.package-lock.json: ui/package-lock.json
	$(NPM) ci
	@touch $@
ui/dist/index.html: ui/node_modules/.package-lock.json $(UI_SOURCES)
	$(NPM) run --silent build
	@touch $@

# What is shipped, built for speed.
SHIPPED := --package wirebend-window --features wirebend-window/custom-protocol --package wirebend-cli $(DRIVERS:%=--package wirebend-driver-%)
.PHONY: window
window: check-tools window-tools ui/dist/index.html ## the window, the program and its drivers, in target/release
	cargo build --release $(SHIPPED)

# All of it and its tests in one profile, so that nothing is compiled twice: what tests load or start is what they are built with.
# `make test` has clippy compile what is ours, which lints it on the way.
ALL := --workspace --features wirebend-window/custom-protocol
.PHONY: built
built: check-tools firmware-tools window-tools ui/dist/index.html ## what tests load or start, with the tests, in target/debug
	cargo build $(ALL) --all-targets

# What is in the packages beside the window: the command line, and the drivers in a folder of their own. Of what is built for tests
# only the .deb is made, in a hurry.
# The largest package that people are asked to fetch.
MAX_BYTES := 15000000
comma := ,
PROFILE := release
FOLDER := target/$(PROFILE)
PACKAGES := target/package
UNPACKED := target/package/unpacked
BUNDLES := $(if $(filter release,$(PROFILE)),deb$(comma)rpm,deb)
# The bundler packs with gzip: with xz the package is a third smaller.
REPACK = dpkg-deb --raw-extract $(FOLDER)/bundle/deb/*.deb $(UNPACKED) \
	&& sed -i 's/^Maintainer: .*/Maintainer: The WireBend-kit authors <authors@wirebend.invalid>/' $(UNPACKED)/DEBIAN/control \
	&& strip --strip-unneeded $(UNPACKED)/usr/bin/* \
	&& chmod -R u=rwX,go=rX $(UNPACKED) \
	&& dpkg-deb --root-owner-group $(if $(filter release,$(PROFILE)),-Zxz,-Zgzip -z1) --build $(UNPACKED) $(PACKAGES)/ >/dev/null && rm -r $(UNPACKED)

.PHONY: package
package: window packed ## .deb and .rpm with window, command line, drivers and profiles, in target/package

# From what is built already.
.PHONY: packed
packed:
	@rm -rf $(PACKAGES) $(FOLDER)/bundle && mkdir -p $(PACKAGES)/drivers
	cp $(FOLDER)/wirebend $(PACKAGES)/
	cp $(foreach driver,$(subst -,_,$(DRIVERS)),$(FOLDER)/libwirebend_driver_$(driver).so) $(PACKAGES)/drivers/
	strip --strip-unneeded $(PACKAGES)/wirebend $(PACKAGES)/drivers/*.so
	cd src-tauri && ../ui/node_modules/.bin/tauri bundle --bundles $(BUNDLES) $(if $(filter release,$(PROFILE)),,--debug)
	$(if $(filter release,$(PROFILE)),cp $(FOLDER)/bundle/rpm/*.rpm $(PACKAGES)/)
	$(REPACK)
	@$(if $(filter release,$(PROFILE)),for file in $(PACKAGES)/*.deb; do \
		test "$$(wc -c < $$file)" -le $(MAX_BYTES) || { echo "$$file is larger than $(MAX_BYTES) bytes" >&2; exit 1; }; done)
	@ls -l $(PACKAGES)

# Its runtime is fetched while it is made, so that it belongs to releases alone.
.PHONY: appimage
appimage: package ## an AppImage besides, in target/package (fetches its runtime)
	cd src-tauri && ../ui/node_modules/.bin/tauri bundle --bundles appimage --config '{"bundle": {"linux": {"appimage": {"files": {"/usr/lib/wirebend/drivers": "../target/package/drivers"}}}}}'
	cp target/release/bundle/appimage/*.AppImage $(PACKAGES)/

# $(call together,name,one,other) does both at a time. What the first says comes at the end, and stays in target/name.log; after that the
# last lines of the other once more where it has failed.
together = mkdir -p target; $(2) > target/$(1).log 2>&1 & first=$$!; trap 'kill $$first 2>/dev/null; exit 130' INT TERM HUP; \
	{ { $(3); }; echo $$? > target/$(1).status; } 2>&1 | tee target/$(1)-beside.log; second=$$(cat target/$(1).status); \
	wait $$first; first=$$?; cat target/$(1).log; test $$second = 0 || tail -n 60 target/$(1)-beside.log; exit $$((first | second))

.PHONY: test
# It is built with all the rest.
test: XTASK := target/debug/xtask
# What `cargo clippy` sets for itself; it would check all that others wrote once more, without using what is built.
test: export RUSTC_WORKSPACE_WRAPPER := clippy-driver
test: export CLIPPY_ARGS := -Dwarnings__CLIPPY_HACKERY__
test: check-tools firmware-tools window-tools browser-tools fmt-check compiled unit-and-spare e2e-run ## every check: format, lints, tests, documentation, tidiness, licences, the window in a browser and installed

# Machines wait most of their time. What else is checked before the window gets what they leave of the processor.
.PHONY: unit-and-spare spare
unit-and-spare: built tidy generate-check
	@$(call together,spare,xtask/spare.sh $(MAKE) --no-print-directory XTASK='$(XTASK)' spare,$(MAKE) --no-print-directory unit)
spare: doc-test deny e2e-ready

# What checks the editor keeps one core busy at a time, and the compiler has the other.
.PHONY: compiled ui-test
compiled: ui/dist/index.html
	@$(call together,ui-test,$(MAKE) --no-print-directory ui-test,$(MAKE) --no-print-directory built)
ui-test: ui/dist/index.html ## types, lints and tests of the editor
	$(NPM) run --silent check
	$(NPM) run --silent test

tests/e2e/node_modules/.package-lock.json: tests/e2e/package-lock.json
	npm --prefix tests/e2e ci
	@touch $@

# The editor in a real browser, and the package, unpacked, through WebDriver.
.PHONY: e2e e2e-ready e2e-run
e2e: e2e-ready e2e-run
e2e-ready: built browser-tools tests/e2e/node_modules/.package-lock.json
	@$(MAKE) --no-print-directory packed PROFILE=debug
	npm --prefix tests/e2e run --silent check
# One after the other: each keeps every core busy that it is given, and what waits for the other is not what is to be tested.
e2e-run:
	npm --prefix tests/e2e run --silent installed
	npm --prefix tests/e2e run --silent browser

# Packages are made by tags alone: what a mistake in their recipe would cost is seen before.
.PHONY: release-check
release-check: check-python ## the recipe of the release: against the schema of such recipes, and for holes in its security
	test -x $(PEERS)/bin/python || python3 -m venv $(PEERS)
	$(PEERS)/bin/python -m pip install --quiet --disable-pip-version-check check-jsonschema==$(CHECK_JSONSCHEMA_VERSION) zizmor==$(ZIZMOR_VERSION)
	$(PEERS)/bin/check-jsonschema --builtin-schema vendor.github-workflows .github/workflows/*.yml
	$(PEERS)/bin/zizmor --offline --no-progress .github/workflows/*.yml

# A fresh Debian in a folder, where apt installs the package for whoever has nothing else: as root and as a user. Needs root.
CLEAN := target/clean-debian
.PHONY: clean-debian
clean-debian: package browser-tools tests/e2e/node_modules/.package-lock.json ## the installed package in a fresh Debian, as root and as a user (needs root and debootstrap)
	@command -v debootstrap >/dev/null || { echo "debootstrap is missing; to install it: apt-get install -y debootstrap" >&2; exit 1; }
	rm -rf --one-file-system $(CLEAN)
	debootstrap --variant=minbase --include=ca-certificates bookworm $(CLEAN)
	cp $(PACKAGES)/wirebend-kit_*.deb $(CLEAN)/
	@chroot $(CLEAN) sh -c 'DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends ./wirebend-kit_*.deb webkit2gtk-driver fonts-dejavu-core && useradd -m -u 1000 person'
	@mount -t proc proc $(CLEAN)/proc && mount --bind /dev $(CLEAN)/dev && trap 'umount $(CLEAN)/proc $(CLEAN)/dev' EXIT \
		&& WIREBEND_ROOT=$(CURDIR)/$(CLEAN) npm --prefix tests/e2e run --silent elsewhere \
		&& WIREBEND_ROOT=$(CURDIR)/$(CLEAN) WIREBEND_USER=1000 npm --prefix tests/e2e run --silent elsewhere

.PHONY: screenshots
screenshots: built browser-tools tests/e2e/node_modules/.package-lock.json ## the pictures of the README, in docs/pictures
	npm --prefix tests/e2e run --silent screenshots

.PHONY: bench
bench: check-tools check-python ## figures of this machine, ours and the peer's in the same run, and those of the window
	cargo build --release --package wirebend-cli --package wirebend-benches --package wirebend-driver-host --package wirebend-driver-hostile --package wirebend-driver-template $(DRIVERS:%=--package wirebend-driver-%)
	test -x $(PEERS)/bin/python || python3 -m venv $(PEERS)
	$(PEERS)/bin/python -m pip install --quiet --disable-pip-version-check --requirement benches/peers/requirements.txt
	cargo bench --package wirebend-benches
	cargo run --quiet --release --package wirebend-benches --bin figures -- target/release/wirebend $(PEERS)/bin/python
	cargo run --quiet --release --package wirebend-benches --bin joins -- $(PEERS)/bin/python
	cargo run --quiet --release --package wirebend-benches --bin contacts -- $(PEERS)/bin/python
	cargo run --quiet --release --package wirebend-benches --bin frames -- $(PEERS)/bin/python
	cargo run --quiet --release --package wirebend-benches --bin sequences -- $(PEERS)/bin/python
	cargo run --quiet --release --package wirebend-benches --bin scatter -- $(PEERS)/bin/python
	cargo run --quiet --release --package wirebend-benches --bin searches
	$(MAKE) --no-print-directory bench-window

# The installed window is that of the package that is there; its name and time are in the table.
.PHONY: bench-window
bench-window: window browser-tools tests/e2e/node_modules/.package-lock.json ## the window's part of them: drag, stencil, start, memory; makes the package where there is none
	@ls $(PACKAGES)/wirebend-kit_*.deb >/dev/null 2>&1 || $(MAKE) --no-print-directory package
	cargo build --release --package wirebend-tests-loopback
	npm --prefix tests/e2e run --silent bench

.PHONY: fuzz
fuzz: export CARGO_PROFILE_RELEASE_STRIP := none
fuzz: export CARGO_PROFILE_RELEASE_DEBUG := line-tables-only
fuzz: check-tools check-clang ## search for inputs that break a reader or the firmware, two minutes a target (FUZZ_SECONDS=120)
	@echo "--- fuzz the firmware's core, $(FUZZ_SECONDS) s"
	$(MAKE) --no-print-directory -C firmware fuzz FUZZ_SECONDS=$(FUZZ_SECONDS)
	@cargo fuzz --version >/dev/null 2>&1 || cargo install cargo-fuzz --locked --version $(CARGO_FUZZ_VERSION) --root $(TOOLS)
	@targets=$$(RUSTC_BOOTSTRAP=1 cargo fuzz list) || exit 1; \
	for target in $$targets; do \
		echo "--- fuzz $$target, $(FUZZ_SECONDS) s"; \
		mkdir -p "fuzz/corpus/$$target"; \
		RUSTC_BOOTSTRAP=1 cargo fuzz run --features libfuzzer "$$target" "fuzz/corpus/$$target" "fuzz/seeds/$$target" -- \
			-max_total_time=$(FUZZ_SECONDS) -rss_limit_mb=2048 -max_len=65536 || exit 1; \
	done

# --- parts of the above, to run alone while working

.PHONY: fmt fmt-check
fmt: ui/node_modules/.package-lock.json ## format the code
	cargo fmt --all
	$(NPM) run --silent fmt
fmt-check: ui/node_modules/.package-lock.json
	cargo fmt --all --check
	$(NPM) run --silent fmt:check

.PHONY: lint
lint: ui/dist/index.html ## clippy on everything
	cargo clippy --workspace --all-targets -- -D warnings

# What was just built goes to the disk first: tests keep journals, and would wait for it.
.PHONY: unit doc-test
unit: check-nextest ui/dist/index.html
	sync
	cargo nextest run $(ALL)
# The examples of the documentation, and its pages with what is built already.
doc-test: ui/dist/index.html
	RUSTDOC=$(CURDIR)/xtask/rustdoc.sh PAGES=$(CURDIR)/target/doc cargo test --quiet $(ALL) --doc

# The daily gate: what needs neither a window nor a simulated board nor a browser, nor minutes.
.PHONY: check
check: check-tools check-nextest ui/node_modules/.package-lock.json ## before every commit: format, lints, unit tests of Rust and TypeScript
	@$(call together,check-ui,$(MAKE) --no-print-directory target/checked-ui,\
	cargo fmt --all --check && cargo clippy --quiet --lib --bins -- -D warnings && cargo nextest run --profile daily --lib --bins)

# The editor as it was when it passed: where nothing in it has changed it passes again.
target/checked-ui: $(UI_SOURCES) $(shell find ui -maxdepth 1 -type f) $(shell find ui/scripts ui/rules ui/tests -type f)
	$(NPM) run --silent check
	$(NPM) run --silent test
	@touch $@

.PHONY: doc
# Without the window, to which nobody links: its toolkit would be checked for it alone.
doc:
	env -u RUSTC_WORKSPACE_WRAPPER RUSTDOCFLAGS="-D warnings" cargo doc --workspace --exclude wirebend-window --no-deps

.PHONY: tidy
tidy: ## the rules of the house that the compiler cannot check
	$(XTASK) tidy

.PHONY: generate generate-check
generate: ui/node_modules/.package-lock.json ## write the committed files that are made from code
	cargo xtask examples
	cargo xtask generate
	$(NPM) run --silent generate
generate-check: ui/node_modules/.package-lock.json
	$(XTASK) examples --check
	$(XTASK) generate --check
	$(NPM) run --silent generate:check

# Comes as a crate; compiled for this repository where it is missing, neither optimised nor for a debugger.
.PHONY: check-nextest
check-nextest:
	@cargo nextest --version >/dev/null 2>&1 || CARGO_PROFILE_DEV_DEBUG=0 cargo install cargo-nextest --debug --locked --version $(CARGO_NEXTEST_VERSION) --root $(TOOLS)

# Neither optimised nor for a debugger: it runs for a second, and takes minutes to build otherwise.
# Fetching brings the crates of other systems too, whose licences are looked at although nothing here builds them.
.PHONY: deny
deny:
	@cargo deny --version >/dev/null 2>&1 || CARGO_PROFILE_DEV_DEBUG=0 cargo install cargo-deny --debug --locked --version $(CARGO_DENY_VERSION) --root $(TOOLS)
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
	node=$$(node --version 2>/dev/null | sed 's/^v//'); \
	{ [ -n "$$node" ] && has npm; } || say "Node $(NODE) or newer, with npm, is missing" "apt-get install -y nodejs npm"; \
	[ -z "$$node" ] || printf '%s\n' $(NODE) "$$node" | sort --check=quiet --version-sort \
		|| say "Node $$node is too old, $(NODE) or newer is needed" "npm install --global n && n lts"; \
	{ has cc && has c++; } || say "a C and C++ compiler is missing" "apt-get install -y build-essential"; \
	needed=$$(sed -n 's/^rust-version = "\([0-9.]*\)".*/\1/p' Cargo.toml); \
	found=$$(rustc --version 2>/dev/null | sed 's/^rustc \([0-9.]*\).*/\1/'); \
	if ! has cargo || [ -z "$$found" ]; then \
		say "cargo and rustc (Rust $$needed or newer) are missing" "apt-get install -y rustup && rustup default stable (from Debian 13 and Ubuntu 24.04 on; before that as rustup.rs says)"; \
	else \
		echo "$$found $$needed" | awk '{ split($$1, f, "."); split($$2, n, "."); exit !(f[1] > n[1] || (f[1] == n[1] && f[2] + 0 >= n[2] + 0)) }' \
			|| say "Rust $$found is too old, $$needed or newer is needed" "rustup update stable"; \
		cargo fmt --version >/dev/null 2>&1 || say "rustfmt is missing" "rustup component add rustfmt"; \
		cargo clippy --version >/dev/null 2>&1 || say "clippy is missing" "rustup component add clippy"; \
	fi; \
	[ "$$missing" = 1 ] || echo "every tool that is needed is here"; \
	exit $$missing

# $(call install,packages) is the command that installs them, after fetching the lists of packages, of which a fresh system has none or old
# ones. $(call obtain,packages) gives it where that can be done without asking. What could not be installed is told by whoever looks for
# it next.
install = $(2)apt-get update; $(2)apt-get install -y --no-install-recommends $(1)
obtain = if [ "$$(id -u)" = 0 ]; then as=env; elif sudo -n true 2>/dev/null; then as="sudo -n"; else as=; fi; \
	if [ -n "$$as" ] && command -v apt-get >/dev/null; then $(call install,$(1),$$as ); fi

# The compiler for the controller and the simulator of its chip.
FIRMWARE_PACKAGES := gcc-avr binutils-avr avr-libc libsimavr-dev libelf-dev pkg-config
.PHONY: firmware-tools
firmware-tools:
	@here() { \
		command -v avr-gcc >/dev/null && command -v avr-objcopy >/dev/null && command -v pkg-config >/dev/null \
			&& test -f "$$(avr-gcc -mmcu=atmega328p -print-file-name=crtatmega328p.o 2>/dev/null)" \
			&& pkg-config --exists simavr; \
	}; \
	here && exit 0; $(call obtain,$(FIRMWARE_PACKAGES)); \
	here || { echo "the compiler or the simulator of the firmware is missing; to install them: $(call install,$(FIRMWARE_PACKAGES))" >&2; exit 1; }

# The window's toolkit.
WINDOW_PACKAGES := build-essential pkg-config libwebkit2gtk-4.1-dev
.PHONY: window-tools
window-tools:
	@here() { [ "$$(uname)" != Linux ] || pkg-config --exists webkit2gtk-4.1 2>/dev/null; }; \
	here && exit 0; $(call obtain,$(WINDOW_PACKAGES)); \
	here || { echo "the toolkit of the window is missing; to install it: $(call install,$(WINDOW_PACKAGES))" >&2; exit 1; }

# A screen in memory, a browser, and what drives the window in the tests.
BROWSER_PACKAGES := webkit2gtk-driver xvfb xauth xdotool dbus fonts-dejavu-core
.PHONY: browser-tools
browser-tools:
	@here() { \
		for tool in Xvfb xauth xdotool dbus-daemon WebKitWebDriver; do command -v $$tool >/dev/null || return 1; done; \
	}; \
	browser() { command -v chromium || command -v google-chrome; } >/dev/null; \
	here && browser && exit 0; packages="$(BROWSER_PACKAGES)"; browser || packages="$$packages chromium"; \
	$(call obtain,$$packages); \
	here && browser || { echo "what the tests of the window need is missing; to install it: $(call install,$$packages)" >&2; exit 1; }

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
