# The two commands: `make demo` and `make test`. Both install what they need (Debian packages), build that alone, and run.
# `make setup` installs everything that any command here needs, the programs that a few tests run among it.
BUILD := build/release
OUT := out
configure = cmake --preset release $(1) -DCLEARCUT_PRECOMPILED_HEADERS=ON $(CMAKE_ARGS) > build-configure.log 2>&1 || (cat build-configure.log; exit 1); \
            rm -f build-configure.log

.PHONY: all setup build prove demo test campaign campaign-stepnc web web-checker verify-module test-verify-module test-web windows test-windows python dist packages reproduce-packages docs pictures format lint-viewer test-browser test-freecad clean
all: build

setup:
	@scripts/setup.sh

build:
	@scripts/setup.sh build demo test server solids
	@$(call configure,-DCLEARCUT_TESTS=ON)
	@cmake --build --preset release

# A folder that is configured stays as it is, so that `make demo` after `make test` takes no test away.
demo:
	@scripts/setup.sh build demo server solids
	@[ -e $(BUILD)/build.ninja ] && [ -z "$(CMAKE_ARGS)" ] || { $(call configure,-DCLEARCUT_TESTS=OFF); }
	@cmake --build --preset release --target commands
	@scripts/demo.sh $(BUILD)/apps/cli/clearcut $(OUT)

test: build
	@ctest --preset release

# Random parts with all kinds of cutters and mutants of their programs, judged by the product and by a field of heights. Goes on where it
# ended; CAMPAIGN states seeds, numbers and time: make campaign CAMPAIGN="--first 1 --parts 2000 --mutants 3 --seconds 3600".
CAMPAIGN :=
campaign: build
	@python3 tests/campaign/campaign.py $(BUILD)/apps/cli/clearcut $(BUILD)/tests/campaign_judge $(OUT)/campaign $(CAMPAIGN)
# Random STEP-NC programs, with attributes changed and toolpaths written back: make campaign-stepnc CAMPAIGN="--first 1 --files 300 --mutants 8".
campaign-stepnc: build
	@python3 tests/campaign/stepnc.py $(BUILD)/apps/cli/clearcut $(BUILD)/tests/campaign_judge $(OUT)/campaign $(CAMPAIGN)

# The page without a server: build/web/site, which any static host serves; planning runs in the browser as WebAssembly.
web:
	@scripts/setup.sh build web
	@scripts/sources.sh build/web-sources libpolyclipping pugixml fmtlib
	@cmake --preset web > build-configure.log 2>&1 || (cat build-configure.log; exit 1); rm -f build-configure.log
	@cmake --build --preset web --target site

# Has Coq check the proof of lemma L1 of docs/claim.md, and say what it assumes: nothing.
prove:
	@scripts/setup.sh prove
	@mkdir -p $(BUILD)/prove && cp checker/cover.v $(BUILD)/prove && cd $(BUILD)/prove && coqc cover.v

# The independent checker of witnesses as WebAssembly, one source: build/web-checker/clearcut-check.wasm, and .js that runs it.
web-checker:
	@scripts/web/checker.sh checker/clearcut_check.cpp build/web-checker

# The check of programs as a small WebAssembly module with one function of texts: build/verify-module/package, a folder for npm.
verify-module:
	@scripts/setup.sh build web
	@scripts/sources.sh build/web-sources libpolyclipping pugixml fmtlib
	@cmake --preset verify-module > build-configure.log 2>&1 || (cat build-configure.log; exit 1); rm -f build-configure.log
	@cmake --build --preset verify-module --target verify-module

# That folder as a program uses it; the answers are compared with those of the command where it is built.
test-verify-module: verify-module
	@VERIFY_MODULE_PACKAGE=build/verify-module/package CLEARCUT=$(wildcard $(BUILD)/apps/cli/clearcut) node --test tests/verify_module/verify_module_test.mjs

# The same bytes as the command, for the examples and random parts; then the page in a browser, also without a network.
test-web: web build
	@scripts/web/same_bytes.sh $(BUILD)/apps/cli/clearcut build/web/apps/web
	@scripts/web/browser_test.sh build/web/site $(BUILD)/apps/cli/clearcut

# Clearcut for Windows, compiled here by mingw-w64: build/windows/clearcut-0.1.0-windows-x86_64.zip, which runs from any folder.
windows:
	@scripts/setup.sh build windows
	@scripts/sources.sh build/windows-sources libpolyclipping pugixml fmtlib cpp-httplib musl onetbb
	@cmake --preset windows > build-configure.log 2>&1 || (cat build-configure.log; exit 1); rm -f build-configure.log
	@cmake --build --preset windows --target commands
	@scripts/windows/zip.sh build/windows

# That zip under Wine: the same bytes as the command for all examples, and the server's page.
test-windows: windows build
	@scripts/windows/test.sh $(BUILD)/apps/cli/clearcut build/windows/clearcut-*-windows-x86_64.zip

# The Python module in build/release/python, its wheel, and its tests. PYTHONPATH=build/release/python is all it needs.
python:
	@scripts/setup.sh build python
	@$(call configure,-DCLEARCUT_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3)
	@cmake --build --preset release --target _core commands
	@scripts/python_tests.sh $(BUILD)/apps/cli/clearcut $(BUILD)

# A wheel for /usr/bin/python3 and a source archive, in build/dist; `make python` tries them in a fresh virtual environment.
dist:
	@scripts/setup.sh build python
	@mkdir -p build/dist
	@cd python/backend && for one in sdist wheel; do \
	  /usr/bin/python3 -B -c "import clearcut_build; print('build/dist/' + clearcut_build.build_$$one('../../build/dist'))" || exit 1; done

# Debian packages, a tarball and what they consist of, in build/packages/out; then they are tried in a fresh root.
packages:
	@scripts/setup.sh build server python solids letters sheets mpi packages
	@scripts/packaging/make.sh
	@scripts/packaging/try.sh build/packages/out

# The documentation as pages that open from disk: build/docs/site/index.html.
docs:
	@scripts/setup.sh build python docs
	@$(call configure,-DCLEARCUT_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3)
	@cmake --build --preset release --target _core commands clearcut_library
	@scripts/docs/make.sh $(BUILD)

# All packages a second time, elsewhere and without a compiler cache: they have to be the same to the byte. Takes as long as a first build.
reproduce-packages:
	@scripts/packaging/reproduce.sh build/packages/out

# The README's pictures, after what they show has changed.
pictures: test-browser
	@scripts/docs/pictures.sh $(BUILD)/apps/cli/clearcut

format:
	@scripts/format.sh

# ESLint, types and unit tests of the pages' scripts; needs npm, which the build does not.
lint-viewer:
	@scripts/lint_viewer.sh

# The report page in a browser: plays, steps, clicks, screenshots. Skipped where chromium or npm is absent.
test-browser: build
	@scripts/viewer_browser_test.sh $(BUILD)/apps/cli/clearcut
	@scripts/serve_browser_test.sh $(BUILD)/apps/cli/clearcut

# The FreeCAD add-on, in FreeCAD itself without a window, on models made in the tests. Installs FreeCAD, 1 GB.
test-freecad:
	@scripts/setup.sh build python freecad
	@$(call configure,-DCLEARCUT_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3)
	@cmake --build --preset release --target _core
	@scripts/freecad_tests.sh $(BUILD)

clean:
	rm -rf build out
