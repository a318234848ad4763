// A lossless path (light in a smooth glass box, two mirrors) would never end: from bounce 1000 on it survives with
// at most this probability (model.md, "Roulette").
// uses: constants/path

float long_path_survival(float survival, uint bounce) {
    return bounce >= LONG_PATH && survival > 0.95 ? 0.95 : survival;
}
