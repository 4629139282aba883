# Thin: each target installs what is missing, builds, runs.
.PHONY: build test

build:
	tools/setup
	cmake --preset release >/dev/null
	cmake --build build

test: build
	ctest --test-dir build --output-on-failure -j 2
