# Rayshade in parallel. `make` builds every program under build/; `make help` lists the other goals.
# Variables: SAN=address,undefined (sanitizers), TEST_FILTER='Suite.*' (GoogleTest), CXX, BUILD.

comma := ,
BUILD ?= build$(if $(SAN),/san-$(subst $(comma),-,$(SAN)))

# What the goals need from the system is looked for first (milliseconds), and installed where it is missing.
GOALS := $(filter-out clean help lint $(BUILD)/%,$(or $(MAKECMDGOALS),all))
NEEDS := $(if $(GOALS),build) $(if $(filter test seeds deps,$(GOALS)),test) \
  $(if $(filter deps stability accuracy table1 figures map,$(GOALS)),charts) $(if $(filter deps fuzz,$(GOALS)),fuzz) \
  $(if $(filter bench-count% deps,$(GOALS)),count)
ifneq ($(strip $(if $(findstring n,$(firstword -$(MAKEFLAGS))),,$(NEEDS))),)
ifneq ($(shell sh tests/support/dependencies.sh $(NEEDS) >&2 && echo ready),ready)
$(error something that the build needs is missing: see above)
endif
endif
# A whole machine for the goals that do everything, unless the user said -j himself.
ALL_CORES = $(if $(findstring -j,$(MAKEFLAGS)),,-j$(shell nproc))

OBJ := $(BUILD)/obj
GEN := $(BUILD)/gen
CXX := g++
WARNINGS := -Wall -Wextra -Werror
CPPFLAGS := -I. -I$(GEN) -MMD -MP
OPTIMIZE := -O2 -g
OPTIMIZE_KERNELS := -O3
# Programs are optimized across files, but for the kernels; tests are linked from what was compiled file by file.
LTO = $(if $(findstring clang,$(CXX)),,-flto=auto -ffat-lto-objects)
LTO_AT_LINK = $(LTO)
# The same bits everywhere; roots without a call for an errno that nobody reads.
CXXFLAGS = -std=c++20 $(OPTIMIZE) -ffp-contract=off -fno-math-errno $(WARNINGS)
LDLIBS := -lpng
PVM_ROOT ?= /usr/lib/pvm3
export PVM_ROOT
ifdef SAN
# Less is optimized: that takes about half as long to build, tests less than a third.
OPTIMIZE := -O1 -g1
OPTIMIZE_KERNELS :=
LTO :=
$(OBJ)/tests/%.o: OPTIMIZE := -O0 -g1
CXXFLAGS += -fsanitize=$(SAN) -fno-sanitize-recover=all -fno-omit-frame-pointer
# GCC 12 is wrong about inlined library code once it is instrumented.
CXXFLAGS += $(if $(findstring clang,$(CXX)),,-Wno-maybe-uninitialized)
LDFLAGS += -fsanitize=$(SAN)
endif

CORE := $(filter-out rayshade/main.cc,$(wildcard rayshade/*/*.cc))
PARALLEL := $(wildcard parallel/*.cc) $(filter-out %_main.cc,$(wildcard parallel/sim/*.cc))
PVM := $(filter-out %_main.cc,$(wildcard parallel/pvm/*.cc))
STABILITY := $(filter-out %_main.cc %_test.cc,$(wildcard tests/stability/*.cc))
TESTS := $(sort $(wildcard tests/*/*_test.cc tests/*/*/*_test.cc tests/support/*.cc) $(STABILITY))
TEST_FILTER ?= *

object = $(patsubst %.cc,$(OBJ)/%.o,$(1))
CORE_LIB := $(BUILD)/librayshade.a
PARALLEL_LIB := $(BUILD)/libparallel.a
PVM_LIB := $(BUILD)/libparallel_pvm.a
PROGRAMS := $(BUILD)/rayshade $(patsubst scenes/%.cc,$(BUILD)/%,$(wildcard scenes/*.cc)) \
  $(if $(wildcard parallel/pvm/host_main.cc),$(BUILD)/prayshade) \
  $(if $(wildcard parallel/pvm/trace_main.cc),$(BUILD)/prayshade-trace) \
  $(if $(wildcard parallel/sim/sim_main.cc),$(BUILD)/prayshade-sim)

.PHONY: all deps demo test reference doc gallery stability lint help clean bench calibrate agreement table1 figures map sensitivity reference-parallel fuzz bench-count bench-count-compare accuracy seeds
all: $(PROGRAMS)

help:
	@echo "make            build all programs under build/"
	@echo "make demo       build, render the balls by every schedule on a private virtual machine, print a table"
	@echo "make test       build and run every test"
	@echo "make seeds      ten thousand simulated runs made difficult by seeds (SEEDS_COUNT=10000 SEEDS_FROM=0)"
	@echo "make reference  compare with the pictures of the original program"
	@echo "make reference-parallel  all its scenes by every schedule, to the bit (minutes)"
	@echo "make doc        print doc/messages.md from the catalogue of messages"
	@echo "make calibrate  measure this machine for the simulator; make agreement compares the two"
	@echo "make table1     the paper's table 1 on its machine, simulated; figures: its figures 7 and 8 (TIMELINES=...)"
	@echo "make map        which schedule wins where; sensitivity: what each constant of the machine changes"
	@echo "make bench      the table of times as ratios (BENCH_RUNS=5 BENCH_PIXELS=1024 BENCH_SCENES=... RAYSHADE4=...)"
	@echo "make bench-count  instructions for small scenes; bench-count-compare: against the commit before"
	@echo "make accuracy   error against time, drawn into doc/charts (ten minutes; gnuplot)"
	@echo "make gallery    render the small pictures of doc/scene_language.md"
	@echo "make stability  errors of intersections, self-intersections, with charts in doc/charts"
	@echo "make fuzz       a million mutated scenes to the parser (FUZZ_RUNS=1000000)"
	@echo "make lint       who includes whom, and the format"
	@echo "make deps       install what is missing for all of this (apt-get; root or sudo)"
	@echo "make clean      remove build/"

deps:
	@echo "Nothing is missing."

# The texts of the simulated machines become a part of prayshade-sim.
MACHINES := $(wildcard parallel/sim/machines/*.machine)
$(GEN)/parallel/sim/machines.cc: $(MACHINES) Makefile
	@mkdir -p $(@D)
	@{ echo '#include "parallel/sim/machine.h"'; echo 'namespace rayshade::parallel {'; \
	  echo 'static const BuiltInMachine kMachines[] = {'; \
	  for m in $(MACHINES); do printf '{"%s", R"text(' "$$(basename $$m .machine)"; cat $$m; echo ')text"},'; done; \
	  echo '};'; echo 'std::span<const BuiltInMachine> BuiltInMachines() { return kMachines; }'; echo '}'; } > $@

# Generated parser; its own warnings are not ours.
$(GEN)/rayshade/scene/grammar.cc $(GEN)/rayshade/scene/grammar.h &: rayshade/scene/grammar.y
	@mkdir -p $(@D)
	bison -o $(GEN)/rayshade/scene/grammar.cc --defines=$(GEN)/rayshade/scene/grammar.h $<
$(GEN)/rayshade/scene/lexer.cc: rayshade/scene/lexer.l
	@mkdir -p $(@D)
	flex -o $@ $<
GENERATED := $(OBJ)/gen/grammar.o $(OBJ)/gen/lexer.o
$(OBJ)/gen/%.o: $(GEN)/rayshade/scene/%.cc $(GEN)/rayshade/scene/grammar.h
	@mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) $(CXXFLAGS) -Wno-error -w -c -o $@ $<
$(OBJ)/gen/machines.o: $(GEN)/parallel/sim/machines.cc
	@mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) $(CXXFLAGS) -c -o $@ $<
$(call object,$(wildcard rayshade/scene/*.cc)): | $(GEN)/rayshade/scene/grammar.h

$(OBJ)/rayshade/%.o $(OBJ)/parallel/%.o: CXXFLAGS += $(LTO)
$(BUILD)/unit_tests: LTO_AT_LINK := -fno-lto
# Reading and building take most of a short run on a large scene.
$(GENERATED) $(call object,$(addprefix rayshade/accel/,build.cc pieces.cc split.cc)): CXXFLAGS += $(OPTIMIZE_KERNELS)
# One kernel source per instruction set; which one runs is decided at start (accel/).
$(OBJ)/rayshade/accel/%_avx2.o: CXXFLAGS += $(OPTIMIZE_KERNELS) -fno-lto -mavx2 -mbmi -mbmi2
$(OBJ)/rayshade/accel/%_avx512.o: CXXFLAGS += $(OPTIMIZE_KERNELS) -fno-lto -mavx512f -mavx512dq -mavx512vl -mavx512bw -mprefer-vector-width=512
$(OBJ)/rayshade/accel/%_plain.o: CXXFLAGS += $(OPTIMIZE_KERNELS) -fno-lto

$(OBJ)/%.o: %.cc
	@mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) $(CXXFLAGS) -c -o $@ $<

$(CORE_LIB): $(call object,$(CORE)) $(if $(wildcard rayshade/scene/grammar.y),$(GENERATED))
	rm -f $@ && ar rcs $@ $^
$(PARALLEL_LIB): $(call object,$(PARALLEL)) $(OBJ)/gen/machines.o
	rm -f $@ && ar rcs $@ $^
$(PVM_LIB): $(call object,$(PVM))
	rm -f $@ && ar rcs $@ $^

LINK = $(CXX) $(CXXFLAGS) $(LTO_AT_LINK) $(LDFLAGS) -o $@ $(filter %.o,$^) $(filter %.a,$^) $(LDLIBS)
$(BUILD)/rayshade: $(OBJ)/rayshade/main.o $(CORE_LIB)
	$(LINK)
$(BUILD)/prayshade: $(OBJ)/parallel/pvm/host_main.o $(PVM_LIB) $(PARALLEL_LIB) $(CORE_LIB)
	$(LINK) -lpvm3
$(BUILD)/prayshade-trace: $(OBJ)/parallel/pvm/trace_main.o $(PVM_LIB) $(PARALLEL_LIB) $(CORE_LIB)
	$(LINK) -lpvm3
$(BUILD)/prayshade-sim: $(OBJ)/parallel/sim/sim_main.o $(PARALLEL_LIB) $(CORE_LIB)
	$(LINK)
$(patsubst scenes/%.cc,$(BUILD)/%,$(wildcard scenes/*.cc)): $(BUILD)/%: $(OBJ)/scenes/%.o
	$(LINK)
$(BUILD)/unit_tests: $(call object,$(TESTS)) $(PVM_LIB) $(PARALLEL_LIB) $(CORE_LIB)
	$(LINK) $(if $(wildcard parallel/pvm/*.cc),-lpvm3) -lgtest_main -lgtest -lpthread

$(BUILD)/step_costs: $(OBJ)/tests/bench/step_costs.o $(PARALLEL_LIB) $(CORE_LIB)
	$(LINK)
$(BUILD)/ping_pong: $(OBJ)/tests/bench/ping_pong.o $(PVM_LIB) $(PARALLEL_LIB) $(CORE_LIB)
	$(LINK) -lpvm3

demo:
	@$(MAKE) --no-print-directory $(ALL_CORES) all
	@tests/support/demo.sh $(BUILD)

test:
	@$(MAKE) --no-print-directory $(ALL_CORES) $(BUILD)/unit_tests all
	@tests/support/run_tests.sh $(BUILD) '$(TEST_FILTER)'

# Seeds that make simulated runs difficult; a few hundred of them are in `make test`.
SEEDS_COUNT ?= 10000
SEEDS_FROM ?= 0
seeds:
	@$(MAKE) --no-print-directory $(ALL_CORES) $(BUILD)/unit_tests $(BUILD)/prayshade-sim
	@SEEDS_COUNT=$(SEEDS_COUNT) SEEDS_FROM=$(SEEDS_FROM) $(BUILD)/unit_tests --gtest_filter='Seeds.*'

# Every scene of the reference set beside the original's picture; SEEDS=0 leaves the random ones out.
REFERENCE ?= $(or $(RAYSHADE_SHARED),../shared)/reference/public
SEEDS ?= 100
$(BUILD)/compare_reference: $(OBJ)/tests/pictures/reference_main.o $(CORE_LIB)
	$(LINK)
reference: $(BUILD)/compare_reference $(BUILD)/rayshade
	@mkdir -p $(BUILD)/reference
	@$(BUILD)/compare_reference $(abspath $(BUILD)/rayshade) $(abspath $(REFERENCE)) \
	  $(abspath $(BUILD)/reference) --seeds $(SEEDS) $(SCENES)

# Every scene of the reference set and of the gallery, at its own size, by all three schedules with 1, 4 and 7 processes.
reference-parallel: $(BUILD)/unit_tests
	RAYSHADE_FULL_SIZE=1 $(BUILD)/unit_tests --gtest_brief=1 --gtest_filter='*EveryScene*'

$(BUILD)/print_messages: $(OBJ)/tests/parallel/print_messages_main.o $(PARALLEL_LIB) $(CORE_LIB)
	$(LINK)
doc: $(BUILD)/print_messages
	$(BUILD)/print_messages > doc/messages.md

# Ratios of tracing times; the loop of Embree calls is built where libembree-dev is there.
$(BUILD)/embree_loop: tests/bench/embree_loop.cc
	@mkdir -p $(@D)
	$(CXX) -std=c++20 -O3 -march=native -o $@ $< -lembree3
bench: all $(if $(wildcard /usr/include/embree3/rtcore.h),$(BUILD)/embree_loop)
	@tests/bench/bench.sh $(BUILD)

# The simulator's machines: measured here, and compared with real runs.
calibrate: all $(BUILD)/ping_pong $(BUILD)/step_costs
	@tests/bench/calibrate.sh $(BUILD)
agreement: all
	@tests/bench/agreement.sh $(BUILD)

# The paper's experiments on the simulated machine; RAYSHADE_SHARED: where the real conference room is, if anywhere.
table1 map sensitivity: $(BUILD)/prayshade-sim $(BUILD)/sphereflake
	@doc/charts/$@.sh $(BUILD)
figures: $(BUILD)/prayshade-sim
	@doc/charts/figures.sh $(BUILD) $(TIMELINES)

# Instructions for small scenes; -compare builds the commit before and fails where there are over 3% more.
bench-count bench-count-compare:
	@$(MAKE) --no-print-directory $(ALL_CORES) $(BUILD)/rayshade $(BUILD)/sphereflake
	@tests/bench/prepare_counts.sh $(BUILD)/sphereflake $(BUILD)/count
	@$(if $(findstring compare,$@),tests/bench/compare_counts.sh $(BUILD),tests/bench/count.sh $(BUILD)/rayshade $(BUILD)/count)

# Error against time of every choice that trades one for the other; charts and data in doc/charts.
$(BUILD)/accuracy: $(call object,tests/bench/accuracy_main.cc tests/bench/measured_scene.cc) $(CORE_LIB)
	$(LINK)
$(BUILD)/precision: tests/bench/precision.cc tests/bench/ball_tracer.h
	@mkdir -p $(@D)
	$(CXX) -I. $(CXXFLAGS) -O3 -o $@ $<
$(BUILD)/compare_blocks: $(call object,tests/bench/compare_blocks.cc) $(CORE_LIB)
	$(LINK)
accuracy: $(BUILD)/rayshade $(BUILD)/accuracy $(BUILD)/precision $(BUILD)/compare_blocks
	@tests/bench/accuracy.sh $(BUILD) doc/charts

# The pictures of the manual of the scene language; they are the same on every machine.
GALLERY := $(patsubst scenes/gallery/%.ray,doc/gallery/%.png,$(wildcard scenes/gallery/*.ray))
gallery: $(GALLERY)
doc/gallery/%.png: scenes/gallery/%.ray $(BUILD)/rayshade
	@mkdir -p $(@D)
	$(BUILD)/rayshade -q -O $@ $<

# Errors of intersections over distance and size, with the charts of doc/stability.md; RAYS for each point.
RAYS ?= 1000
$(BUILD)/stability $(BUILD)/spawned: $(BUILD)/%: $(OBJ)/tests/stability/%_main.o \
  $(call object,$(STABILITY)) $(CORE_LIB)
	$(LINK)
stability: $(BUILD)/stability $(BUILD)/spawned
	@mkdir -p doc/charts/data
	@$(BUILD)/stability doc/charts/data $(RAYS)
	@gnuplot -e "data='doc/charts/data'; charts='doc/charts'" tests/stability/stability.gp
	@$(BUILD)/spawned doc/charts/data

# The parser under libFuzzer and sanitizers: all that it links with, compiled by clang.
FUZZ_RUNS ?= 1000000
FUZZ_FLAGS := CXX=clang++ SAN=fuzzer-no-link,address,undefined BUILD=$(BUILD)/fuzz
FUZZ_CORE := $(foreach folder,common geom surface texture light image scene,$(wildcard rayshade/$(folder)/*.cc))
$(BUILD)/libparser.a: $(call object,$(FUZZ_CORE)) $(GENERATED)
	rm -f $@ && ar rcs $@ $^
$(BUILD)/parse_fuzz: $(OBJ)/tests/fuzz/parse_fuzz.o $(BUILD)/libparser.a
	$(LINK) -fsanitize=fuzzer
fuzz:
	@$(MAKE) --no-print-directory $(ALL_CORES) $(FUZZ_FLAGS) $(BUILD)/fuzz/parse_fuzz
	@tests/fuzz/fuzz.sh $(BUILD)/fuzz/parse_fuzz $(BUILD)/fuzz $(FUZZ_RUNS) $(wildcard $(REFERENCE))

lint:
	@tests/support/lint.sh

clean:
	rm -rf build

-include $(shell find $(OBJ) -name '*.d' 2>/dev/null)
