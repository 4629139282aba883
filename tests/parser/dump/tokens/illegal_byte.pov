sphere é box
