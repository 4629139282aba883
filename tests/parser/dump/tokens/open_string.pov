sphere { "never ends
