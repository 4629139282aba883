# Thin: each target installs what is missing, builds, runs. A second run does nothing twice.
.PHONY: build render test conformance coverage accuracy cost report estimate compare bench asan setup setup-test setup-bench

build: build/build.ninja
	@cmake --build build

# Renders the showcase scene and says where the picture is.
render: build/build.ninja
	@cmake --build build --target lute
	@$(MAKE) -s render/lute.png
	@echo "picture: $(CURDIR)/render/lute.png"

render/lute.png: build/bin/lute scenes/showcase/lute.pov
	@mkdir -p render
	@build/bin/lute scenes/showcase/lute.pov --width 900 --height 600 --antialias 0.2 --output $@

test: setup-test build
	@ctest --test-dir build --output-on-failure -j 2

# Everything that compares with POV-Ray, and every example scene (ten minutes the first time).
conformance: setup-test build
	@ctest --test-dir build --output-on-failure -L conformance
	@build/bin/lute-compare state --jobs 2 --output build/conformance

# What of the language renders as in POV-Ray: docs/coverage.md.
coverage: setup-test build
	@build/bin/lute-compare coverage --jobs 2 --output build/coverage --page docs/coverage.md

# The table of docs/accuracy.md: extreme scenes with both programs, against closed forms and symmetries.
accuracy: setup-test build
	@cmake --build build --target lute-accuracy
	@build/bin/lute-accuracy docs/accuracy.md

# The table of docs/cost.md: what a scene pays for features that it does not use. Five builds.
cost: setup-bench build/build.ninja
	@tools/measure-cost

# Error against run time of both programs on ten scenes: report/sweep.html, the table of docs/antialiasing.md and the chart
# of the README.
REPORT_SCENES = scenes/showcase/lute.pov $(addprefix scenes/lecture/,refraction.pov mirror.pov torus.pov brick.pov \
  spotlight.pov filter_transmit.pov csg_difference.pov checker.pov sky_sphere.pov)
# The same for what scenes set themselves: accuracy of an isosurface, lamps of an area light, sturm.
SETTINGS = --runs 3 --size 80x60 --into docs/antialiasing.md
EXACTLY = +A0.05 +R5
report: setup-test build
	@build/bin/lute-compare sweep $(REPORT_SCENES) --size 240x180 --output report --into docs/antialiasing.md
	@build/bin/lute-compare sweep scenes/sweep/isosurface_accuracy.pov $(SETTINGS) --section accuracy --output report/accuracy \
	  --vary $(foreach v,0.3 0.1 0.03 0.01 0.001 1e-6,'$(EXACTLY) Declare=Accuracy=$(v)')
	@build/bin/lute-compare sweep scenes/sweep/area_light.pov $(SETTINGS) --section lamps --output report/lamps \
	  --vary $(foreach v,2 3 5 7 9,'$(EXACTLY) Declare=Lamps=$(v)')
	@build/bin/lute-compare sweep scenes/sweep/sturm.pov $(SETTINGS) --section sturm --output report/sturm \
	  --vary $(foreach v,0 1,'$(EXACTLY) Declare=Sturm=$(v)')
	@chromium-headless-shell --no-sandbox --disable-gpu --hide-scrollbars --window-size=900,420 \
	  --screenshot=docs/images/error-over-time.png "file://$(CURDIR)/report/lute.pov.svg"

# How good the error is that +AM3 estimates, on the same ten scenes: a table of docs/antialiasing.md (two minutes).
estimate: build/build.ninja
	@cmake --build build --target lute-estimate lute-compare
	@build/bin/lute-estimate $(REPORT_SCENES) > build/estimate.md
	@build/bin/lute-compare section docs/antialiasing.md estimate < build/estimate.md

# Both programs on our scenes, side by side: report/report.html.
compare: setup-test build
	@build/bin/lute-compare run scenes/lecture scenes/showcase --output report

bench: setup-bench build/build.ninja
	@cmake --preset release -DLUTE_BUILD_BENCH=ON >/dev/null
	@cmake --build build --target lute-bench-accel lute-bench-noise lute lute-compare
	@build/bin/lute-bench-accel --benchmark_min_time=1
	@build/bin/lute-bench-noise --benchmark_min_time=1
	@build/bin/lute-compare speed bench/scene --timeout 300 --into docs/shapes.md
	@bench/memory.sh

# Every test under the sanitizers of addresses and undefined behaviour (half an hour). Their stack frames are several times as large, and
# what they keep of freed memory counts against the limit of a scene.
asan: setup-test
	@cmake --preset asan >/dev/null
	@cmake --build build-asan
	@ulimit -s 65536 && ASAN_OPTIONS=quarantine_size_mb=16 ctest --test-dir build-asan --output-on-failure -j 2 --timeout 1500

build/build.ninja: | setup
	@cmake --preset release >/dev/null

setup:
	@tools/setup

setup-test:
	@tools/setup test

setup-bench:
	@tools/setup bench
