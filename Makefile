# The two commands: `make demo` and `make test`. Both install what they need (Debian packages), build that alone, and run.
# `make setup` installs everything that any command here needs, the programs that a few tests run among it.
BUILD := build/release
OUT := out
# Common headers are parsed once. Continuous integration sets OFF, so that no source lacks an include unseen.
PRECOMPILED ?= ON
configure = cmake --preset release $(1) -DCLEARCUT_PRECOMPILED_HEADERS=$(PRECOMPILED) $(CMAKE_ARGS) > build-configure.log 2>&1 || (cat build-configure.log; exit 1); \
            rm -f build-configure.log

.PHONY: all setup build demo test python format lint-viewer test-browser clean
all: build

setup:
	@scripts/setup.sh

build:
	@scripts/setup.sh build demo test
	@$(call configure,-DCLEARCUT_TESTS=ON)
	@cmake --build --preset release

# A folder that is configured stays as it is, so that `make demo` after `make test` takes no test away.
demo:
	@scripts/setup.sh build demo
	@[ -e $(BUILD)/build.ninja ] && [ -z "$(CMAKE_ARGS)" ] || { $(call configure,-DCLEARCUT_TESTS=OFF); }
	@cmake --build --preset release --target clearcut
	@scripts/demo.sh $(BUILD)/apps/cli/clearcut $(OUT)

test: build
	@ctest --preset release

# The Python module in build/python/python, its wheel, and its tests. PYTHONPATH=build/python/python is all it needs.
python:
	@scripts/setup.sh build python
	@cmake --preset python -DPython_EXECUTABLE=/usr/bin/python3 > build-configure.log 2>&1 || (cat build-configure.log; exit 1); rm -f build-configure.log
	@cmake --build --preset python --target _core clearcut
	@scripts/python_tests.sh build/python/apps/cli/clearcut build/python

format:
	@scripts/format.sh

# ESLint over the report's scripts and style; needs npm, which the build does not.
lint-viewer:
	@scripts/lint_viewer.sh

# The report page in a browser: plays, steps, clicks, screenshots. Skipped where chromium or npm is absent.
test-browser: build
	@scripts/viewer_browser_test.sh $(BUILD)/apps/cli/clearcut

clean:
	rm -rf build out
