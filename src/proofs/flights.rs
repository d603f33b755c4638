//! Where rays are inside of `traverse`, for the proof that counts them.
use crate::units::traversal::Traverse;
use std::fmt::Write;

/// The places of `traverse` that hold a ray: nets of the valid bit and of the tag.
pub(super) struct Flights(Vec<(String, String)>);

impl Flights {
    pub(super) fn of(t: &Traverse, skids: bool) -> Self {
        let mut list = vec![("s0_back_valid".to_string(), "s0_back_tag".to_string())];
        list.extend((1..t.slots).map(|k| (format!("s{k}_valid"), format!("s{k}_tag"))));
        list.extend((1..=t.setup).map(|k| (format!("u_setup_delay.s{k}_valid"), format!("u_setup_delay.s{k}_data"))));
        list.extend((1..=t.finish).map(|k| (format!("u_hit_valid.s{k}_valid"), format!("u_hit_tag.s{k}_data"))));
        if skids {
            for (unit, tag) in [("u_setup_skid", "new_tag"), ("u_hit_skid", "waiting_tag")] {
                list.extend(["first", "second"].map(|k| (format!("{unit}.{k}_valid"), format!("{unit}_{tag}.{k}"))));
            }
        }
        Self(list)
    }

    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// When a ray is done is left open, so what is proved holds whatever the datapath computes.
    pub(super) fn script(&self) -> String {
        let mut s = "cd fv_traverse\ncutpoint w:dut.s0_back_done\n".to_string();
        for (k, (valid, tag)) in self.0.iter().enumerate() {
            writeln!(s, "connect -nounset -set holds_{k} \\dut.{valid}\nconnect -nounset -set tag_{k} \\dut.{tag}")
                .expect("writing to a string");
        }
        s + "cd ..\n"
    }
}
