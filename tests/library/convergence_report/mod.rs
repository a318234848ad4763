//! What `vkpt converge` shows of an experiment: the table, the plot, compared with logarithms and the labels of
//! its own ticks, and the page, compared with the record.

mod page;
mod plot;
mod records;
mod table;
