//! Ray parameters of all height codes, made once for each format and code width.
use reliefrtl_base::format::FloatFormat;
use std::cell::RefCell;
use std::sync::Arc;

/// What a table is of: the datapath that it belongs to, the format, bits of a code.
type Key = (&'static str, FloatFormat, u32);

thread_local! {
    /// The table that was made last. A model of a single unit is prepared row by row, and a table may have 65536 entries.
    static LAST: RefCell<Option<(Key, Arc<[u64]>)>> = const { RefCell::new(None) };
}

/// `of` of each code of `key.2` bits.
pub(crate) fn height_times(key: Key, of: impl Fn(u64) -> u64) -> Arc<[u64]> {
    LAST.with_borrow_mut(|last| match last {
        Some((found, table)) if *found == key => table.clone(),
        _ => {
            let table: Arc<[u64]> = (0..1u64 << key.2).map(of).collect();
            *last = Some((key, table.clone()));
            table
        }
    })
}
