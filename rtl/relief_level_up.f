relief_level_up.v
