//! Scripts that render in parts on many machines: which samples each part has, and the texts.

mod scripts;
mod shares;
