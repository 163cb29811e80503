#pragma once

namespace lumi {

/// Runs `Kernel::run(arguments...)` as compiled for the widest vectors of this machine.
///
/// `run` is a static function marked LUMI_KERNEL: it is inlined into one function for each
/// instruction set, of which one is chosen at run time. Only for loops whose results cannot differ
/// between them: integers, and floating point without fused or reordered steps.
#define LUMI_KERNEL [[gnu::always_inline]] static inline

#if defined(__x86_64__) && defined(__GNUC__)

template <class Kernel, class... Arguments>
[[gnu::target("avx2")]] void run_avx2(Arguments... arguments) {
    Kernel::run(arguments...);
}

template <class Kernel, class... Arguments>
[[gnu::target("avx512f,avx512bw,avx512vl,avx512dq,prefer-vector-width=512")]] void run_avx512(
    Arguments... arguments) {
    Kernel::run(arguments...);
}

enum class InstructionSet { kPortable, kAvx2, kAvx512 };

/// The widest that the processor and its operating system offer.
[[nodiscard]] inline InstructionSet widest_instruction_set() {
    if (__builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512dq")) {
        return InstructionSet::kAvx512;
    }
    return __builtin_cpu_supports("avx2") ? InstructionSet::kAvx2 : InstructionSet::kPortable;
}

template <class Kernel, class... Arguments>
void run_on(InstructionSet set, Arguments... arguments) {
    switch (set) {
        case InstructionSet::kAvx512:
            return run_avx512<Kernel>(arguments...);
        case InstructionSet::kAvx2:
            return run_avx2<Kernel>(arguments...);
        case InstructionSet::kPortable:
            return Kernel::run(arguments...);
    }
}

#else

enum class InstructionSet { kPortable };
[[nodiscard]] inline InstructionSet widest_instruction_set() { return InstructionSet::kPortable; }

template <class Kernel, class... Arguments>
void run_on(InstructionSet, Arguments... arguments) {
    Kernel::run(arguments...);
}

#endif

/// What `run_fastest` runs on. Tests set it to narrower ones, to compare what comes out.
[[nodiscard]] inline InstructionSet& instruction_set_in_use() {
    static InstructionSet set = widest_instruction_set();
    return set;
}

template <class Kernel, class... Arguments>
void run_fastest(Arguments... arguments) {
    run_on<Kernel>(instruction_set_in_use(), arguments...);
}

}  // namespace lumi
