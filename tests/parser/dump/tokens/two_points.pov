sphere 1.2.3 box
