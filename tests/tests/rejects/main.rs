//! Every test rejects something: for each name a small mutant that it must catch, through the public interface; and facts fail
//! without any p-value.

mod by_design;
mod chromatic;
mod density;
mod direction;
mod discrete;
mod estimates;
mod every_test;
mod facts;
mod integral;
mod joint;
mod later;
mod laws;
mod order;
mod path;
mod ramp;
mod states;
mod table_2d;
mod walks;
