# Thin: each target installs what is missing, builds, runs.
.PHONY: bench build test

build:
	tools/setup
	cmake --preset release >/dev/null
	cmake --build build

test: build
	ctest --test-dir build --output-on-failure -j 2

# Needs Google Benchmark and Embree 3 (Debian: libbenchmark-dev, libembree-dev).
bench:
	tools/setup
	cmake --preset release -DLUTE_BUILD_BENCH=ON >/dev/null
	cmake --build build --target lute-bench-accel
	build/bin/lute-bench-accel --benchmark_min_time=1
