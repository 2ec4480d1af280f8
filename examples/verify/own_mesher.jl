# A mesher of one's own, and its verdict by exit code:  julia own_mesher.jl

ring = [(0.0, 0.0), (0.3, -0.1), (1.0, 0.0), (1.2, 0.7), (0.5, 1.1)]
open("own.node", "w") do file
    println(file, length(ring), " 2 0 0")
    foreach(((i, p),) -> println(file, i, " ", p[1], " ", p[2]), enumerate(ring))
end
open("own.ele", "w") do file
    println(file, length(ring) - 2, " 3 0")
    foreach(i -> println(file, i, " 1 ", i + 1, " ", i + 2), 1:length(ring)-2)
end
command = `bern-exact verify own.ele --numbers binary64 --max-angle 150`
println(success(pipeline(command; stdout)) ? "valid" : "not valid")
