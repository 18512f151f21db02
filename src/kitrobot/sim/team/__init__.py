"""What a team agrees on and shares, over the tables: meetings, units of work, vacancies, shared variables, radio."""
