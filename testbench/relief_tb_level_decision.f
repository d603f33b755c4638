../rtl/relief_level_decision.v
relief_tb_level_decision.v
relief_tb_level_decision_top.v
