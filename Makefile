# The two commands: `make demo` and `make test`. Both install what is missing (Debian packages), build, and run.
BUILD := build/release
OUT := out

.PHONY: all setup build demo test format tidy clean
all: build

setup:
	@scripts/setup.sh

build: setup
	@cmake --preset release $(CMAKE_ARGS) > build-configure.log 2>&1 || (cat build-configure.log; exit 1)
	@rm -f build-configure.log
	@cmake --build --preset release

demo: build
	@scripts/demo.sh $(BUILD)/apps/cli/clearcut $(OUT)

test: build
	@ctest --preset release

format:
	@scripts/format.sh

clean:
	rm -rf build out
