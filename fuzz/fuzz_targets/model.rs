#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| vkpt_fuzz::model(bytes));
