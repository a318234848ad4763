#![no_main]

// `decode` makes a refusal of a panic inside a decoder: what escapes it still ends the run.
libfuzzer_sys::fuzz_target!(
    init: drop(std::panic::take_hook()),
    |bytes: &[u8]| vkpt_fuzz::picture(bytes)
);
