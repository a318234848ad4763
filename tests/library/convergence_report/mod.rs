//! What `vkpt converge` shows of an experiment: the plot, held against logarithms and the labels of its own ticks, and
//! the page, held against the record.

mod page;
mod plot;
mod records;
